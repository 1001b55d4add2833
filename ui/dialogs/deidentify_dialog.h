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

struct ShareOptions {
    Toggle identity = Toggle::Off;   ///< whether to keep the patient identity
    Toggle shiftedDates = Toggle::Off;   ///< whether to shift dates instead of removing them
    Toggle maskText = Toggle::Off;   ///< whether to mask burned-in text
    QString pseudonym;   ///< if empty, a pseudonym is generated
};

/// Dialog for sharing a case, which is de-identified unless the user keeps the identity. Emits `chosen` on Pack.
class PackDialog : public QDialog {
    Q_OBJECT
public:
    explicit PackDialog(QWidget* parent);

    ShareOptions options() const;

signals:
    void chosen(const ui::ShareOptions& options);

private:
    QCheckBox* deidentify_;
    QCheckBox* shiftedDates_;
    QCheckBox* maskText_;
    QLineEdit* pseudonym_;
};

/// Files to de-identify, the destination and the options.
struct DeidentifyOptions {
    QStringList paths;   ///< input files and folders
    QString outputFolder;
    ShareOptions sharing;   ///< `identity` is always off
};

/// Dialog that collects the files and folders to de-identify. The receiver of its signals opens the file dialogs.
class DeidentifyDialog : public QDialog {
    Q_OBJECT
public:
    explicit DeidentifyDialog(QWidget* parent);

    void addPaths(const QStringList& paths);
    void setOutputFolder(const QString& folder);

signals:
    void addFilesRequested();
    void addFolderRequested();
    void outputFolderRequested();
    void chosen(const ui::DeidentifyOptions& options);

private:
    QWidget* makeInputs();
    QWidget* makeOptions();
    void removeSelected();
    void showState();
    DeidentifyOptions options() const;

    QListWidget* inputs_;
    QPushButton* remove_;
    QCheckBox* shiftedDates_;
    QCheckBox* maskText_;
    QLineEdit* pseudonym_;
    QLineEdit* output_;
    QPushButton* accept_;
};

}   // namespace angiopose::ui
