#pragma once

#include "ui/dialogs/pack_dialog.h"

#include <QDialog>
#include <QStringList>

class QCheckBox;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace angiopose::ui {

/// What is to be written without identity, where and how.
struct DeidentifyChoice {
    QStringList paths;   ///< files and folders
    QString outputFolder;
    PackChoice how;   ///< its identity is off
};

/// Asks which files and folders are written without identity. Where they lie is asked by who hears the wishes.
class DeidentifyDialog : public QDialog {
    Q_OBJECT
public:
    explicit DeidentifyDialog(QWidget* parent);

    void addPaths(const QStringList& paths);
    void setOutputFolder(const QString& folder);

signals:
    void filesWanted();
    void folderWanted();
    void outputWanted();
    void chosen(const ui::DeidentifyChoice& choice);

private:
    QWidget* makeInputs();
    QWidget* makeOptions();
    void removeSelected();
    void showState();
    DeidentifyChoice choice() const;

    QListWidget* inputs_;
    QPushButton* remove_;
    QCheckBox* shiftedDates_;
    QCheckBox* blackedOut_;
    QLineEdit* pseudonym_;
    QLineEdit* output_;
    QPushButton* accept_;
};

}   // namespace angiopose::ui
