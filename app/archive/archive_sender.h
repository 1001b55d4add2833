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

/// DICOM objects of a case, made in a folder of their own and sent to an archive that the user chooses.
class ArchiveSender : public QObject {
    Q_OBJECT
public:
    /// Makes the objects in a folder; called once, by a worker.
    using Maker = std::function<core::Result<DicomFiles>(const std::string& folder, const DicomObserver& observe)>;

    ArchiveSender(ArchiveList& list, QWidget& dialogParent, QObject* parent = nullptr);

    void ask(const Maker& maker);

signals:
    void sent(const QString& words, const QStringList& notes);   ///< all of them; what is to be known of them

private:
    struct Made;   ///< the objects, while the dialog is open
    /// How far the making is, then the sending.
    struct Progress {
        double made = 0.0;
        io::ArchiveProgress sending;
    };

    void send();
    static core::Result<io::TransferReport> work(Made& made, const io::ArchiveNode& node, JobLink<Progress>& link);
    void follow(const Progress& progress);
    void take(const io::TransferReport& report);
    void fail(const core::Error& error);

    ArchiveList& list_;
    QWidget& dialogParent_;
    QPointer<ui::SendDialog> dialog_;
    ArchiveNodes* nodes_ = nullptr;   ///< lives as long as the dialog
    std::shared_ptr<Made> made_;
    Job<io::TransferReport, Progress> job_;
};

}   // namespace angiopose::app
