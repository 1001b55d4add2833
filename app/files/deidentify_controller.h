#pragma once

#include "app/document/case_document.h"
#include "app/jobs/job.h"
#include "io/deidentify_files.h"
#include "ui/dialogs/deidentify_dialog.h"

#include <QObject>
#include <QPointer>
#include <QStringList>

class QWidget;

namespace angiopose::ui {
class BottomStrip;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Converts the de-identification options of the dialog.
io::DeidentificationOptions deidentificationOf(const ui::ShareOptions& options);

/// De-identifies files and folders: asks for options, then writes on a worker thread with progress and a Stop button.
class DeidentifyController : public QObject {
    Q_OBJECT
public:
    DeidentifyController(ui::BottomStrip& strip, QWidget& dialogParent, QObject* parent = nullptr);

    void openDialog();
    void write(const ui::DeidentifyOptions& options);   ///< returns at once
    bool isRunning() const { return job_.isRunning(); }

signals:
    void written(const QString& folder, const QString& summary);
    void partlyRejected(const QString& summary, const QString& details);   ///< `details` has one line per skipped file
    void stopped();
    void failed(const QString& reason);

private:
    void askForFiles();
    void askForFolder();
    void askForOutputFolder();
    void reportOutcome(const io::DeidentifiedFiles& done);
    void reportFailure(const core::Error& error);

    ui::BottomStrip& strip_;
    QWidget& dialogParent_;
    QPointer<ui::DeidentifyDialog> dialog_;
    QString output_;   ///< output path of the current job
    Job<io::DeidentifiedFiles> job_;
};

/// Writes the case in its current state, with its inputs, to one ZIP archive: asks for the options, then writes on a
/// worker thread, with progress and a Stop button.
class PackController : public QObject {
    Q_OBJECT
public:
    PackController(CaseDocument& document, ui::BottomStrip& strip, QWidget& dialogParent, QObject* parent = nullptr);

    void openDialog();
    void write(const ui::ShareOptions& options, const QString& path);   ///< returns at once
    bool isRunning() const { return job_.isRunning(); }

signals:
    void stopped();
    void written(const QString& path, const QStringList& notes);
    void failed(const QString& reason);

private:
    void askForPath(const ui::ShareOptions& options);

    CaseDocument& document_;
    ui::BottomStrip& strip_;
    QWidget& dialogParent_;
    QString archive_;   ///< path of the archive being written
    Job<QStringList> job_;   ///< yields remarks for the user
};

}   // namespace angiopose::app
