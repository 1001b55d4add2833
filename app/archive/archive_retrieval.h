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

/// Brings studies and series from an archive into the cache, and says what became of them.
class ArchiveRetrieval : public QObject {
    Q_OBJECT
public:
    explicit ArchiveRetrieval(ui::ArchiveDialog& dialog, QObject* parent = nullptr);

    void start(const io::ArchiveNode& node, const io::ArchiveSettings& settings,
               const std::vector<io::RetrieveRequest>& requests);
    const QStringList& folders() const { return folders_; }   ///< of the series that came, in part at least

signals:
    void retrieved();   ///< all of it
    void ended();   ///< whatever came
    void unaudited(const QString& reason);   ///< what came is not in the audit file

private:
    /// How far it is, of which of the studies.
    struct Progress {
        io::ArchiveProgress archive;
        std::size_t study = 0, studies = 0;
    };
    struct Came {
        io::TransferReport report;
        std::optional<core::Message> unaudited;   ///< why the audit file lacks it
    };
    using RetrievalJob = Job<Came, Progress>;

    static RetrievalJob::Work workOf(const io::ArchiveNode& node, const io::ArchiveSettings& settings,
                                     const std::vector<io::RetrieveRequest>& requests);
    void stop();
    void follow(const Progress& progress);
    void take(const io::TransferReport& report);

    ui::ArchiveDialog& dialog_;
    QStringList folders_;
    bool hasBegun_ = false;   ///< objects are on their way
    RetrievalJob job_;
};

/// What the cache holds and may hold: shown, limited, emptied.
class ArchiveCache : public QObject {
    Q_OBJECT
public:
    /// What of the dialog it serves.
    struct Ui {
        ui::CacheLine& line;
        ui::TransferLine& words;
        QWidget& dialog;
    };
    ArchiveCache(ArchiveList& list, const Ui& ui, QObject* parent = nullptr);

    void measure();   ///< and show it

private:
    void limit(double gigabytes);
    void setLimit(std::uint64_t bytes);
    void askDropping(std::uint64_t bytes);
    void askEmptying();
    void empty();

    ArchiveList& list_;
    Ui ui_;
    std::uint64_t held_ = 0;   ///< bytes
    Job<std::uint64_t> measuring_;
    Job<std::size_t> emptying_;
};

}   // namespace angiopose::app
