#pragma once

#include "app/archive/archive_list.h"
#include "app/jobs/job.h"
#include "app/texts/dicom_export.h"
#include "io/archive/archive.h"

#include <QObject>
#include <QPointer>
#include <QStringList>

#include <functional>
#include <memory>

class QWidget;

namespace angiopose::ui {
class SendDialog;
}   // namespace angiopose::ui

namespace angiopose::app {

class ArchiveNodes;

/// Creates DICOM objects of a case in a temporary folder and sends them to an archive that the user selects.
class ArchiveSender : public QObject {
    Q_OBJECT
public:
    /// Creates the objects in a folder. Called once, on a worker thread.
    using ObjectWriter =
        std::function<core::Result<DicomFiles>(const std::string& folder, const DicomObserver& observe)>;

    ArchiveSender(ArchiveList& list, QWidget& dialogParent, QObject* parent = nullptr);

    void openDialog(const ObjectWriter& objectWriter);

signals:
    void sent(const QString& summary,
              const QStringList& notes);   ///< emitted when all objects were sent; `notes` holds remarks for the user

private:
    struct CreatedObjects;   ///< objects that were created, kept while the dialog is open
    /// Progress of creating the objects, then of sending them.
    struct Progress {
        double created = 0.0;
        io::ArchiveProgress sending;
    };

    void send();
    static core::Result<io::TransferReport> work(CreatedObjects& created, const io::ArchiveNode& node,
                                                 JobLink<Progress>& link);
    void follow(const Progress& progress);
    void showReport(const io::TransferReport& report);
    void showError(const core::Error& error);

    ArchiveList& list_;
    QWidget& dialogParent_;
    QPointer<ui::SendDialog> dialog_;
    ArchiveNodes* nodes_ = nullptr;   ///< owned by the dialog
    std::shared_ptr<CreatedObjects> created_;
    Job<io::TransferReport, Progress> job_;
};

}   // namespace angiopose::app
