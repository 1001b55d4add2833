#pragma once

#include "ui/dialogs/export_dialog.h"

#include <QDialog>
#include <QString>
#include <QStringList>

class QCheckBox;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace angiopose::ui {

struct PackChoice {
    Choice identity = Choice::Off;   ///< whether it goes with the case
    Choice shiftedDates = Choice::Off;   ///< instead of none
    Choice blackedOut = Choice::Off;   ///< letters that are drawn into the pictures
    QString pseudonym;   ///< empty: made up
};

/// Asks how a case is packed: without identity unless that is wished. `chosen` follows on Pack.
class PackDialog : public QDialog {
    Q_OBJECT
public:
    explicit PackDialog(QWidget* parent);

    PackChoice choice() const;

signals:
    void chosen(const ui::PackChoice& choice);

private:
    QCheckBox* nameless_;
    QCheckBox* shiftedDates_;
    QCheckBox* blackedOut_;
    QLineEdit* pseudonym_;
};

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
