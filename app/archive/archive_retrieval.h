#pragma once

#include "app/archive/archive_list.h"
#include "app/jobs/job.h"
#include "io/archive/archive.h"
#include "io/archive/node_file.h"

#include <QObject>
#include <QStringList>
#include <optional>

namespace angiopose::ui {
class ArchiveDialog;
class CacheLine;
class TransferLine;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Retrieves studies and series from an archive into the cache and reports the outcome.
class ArchiveRetrieval : public QObject {
    Q_OBJECT
public:
    explicit ArchiveRetrieval(ui::ArchiveDialog& dialog, QObject* parent = nullptr);

    void start(const io::ArchiveNode& node, const io::ArchiveSettings& settings,
               const std::vector<io::RetrieveRequest>& requests);
    const QStringList& folders() const { return folders_; }   ///< folders of the series received, completely or in part

signals:
    void retrieved();   ///< emitted when all objects were received
    void ended();   ///< emitted whatever the outcome
    void auditFailed(const QString& reason);   ///< emitted when received objects are missing from the audit file

private:
    /// Progress within the current study, and its index among all studies.
    struct Progress {
        io::ArchiveProgress archive;
        std::size_t study = 0, studies = 0;
    };
    struct RetrievalOutcome {
        io::TransferReport report;
        std::optional<core::Message> auditFailed;   ///< reason why the audit file is incomplete
    };
    using RetrievalJob = Job<RetrievalOutcome, Progress>;

    static RetrievalJob::Work makeRetrieval(const io::ArchiveNode& node, const io::ArchiveSettings& settings,
                                            const std::vector<io::RetrieveRequest>& requests);
    void stop();
    void follow(const Progress& progress);
    void showReport(const io::TransferReport& report);

    ui::ArchiveDialog& dialog_;
    QStringList folders_;
    bool hasReceived_ = false;   ///< true once the first object has arrived
    RetrievalJob job_;
};

/// Shows, limits and empties the cache of received objects.
class ArchiveCache : public QObject {
    Q_OBJECT
public:
    /// Parts of the dialog that the class uses.
    struct Ui {
        ui::CacheLine& line;
        ui::TransferLine& words;
        QWidget& dialog;
    };
    ArchiveCache(ArchiveList& list, const Ui& ui, QObject* parent = nullptr);

    void measure();   ///< measures the size of the cache and shows it

private:
    void limit(double gigabytes);
    void setLimit(std::uint64_t bytes);
    void confirmLowerLimit(std::uint64_t bytes);
    void confirmEmptying();
    void empty();

    ArchiveList& list_;
    Ui ui_;
    std::uint64_t usedBytes_ = 0;   ///< current size of the cache, bytes
    Job<std::uint64_t> measureJob_;
    Job<std::size_t> emptyJob_;
};

}   // namespace angiopose::app
