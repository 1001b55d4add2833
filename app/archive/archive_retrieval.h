#pragma once

#include "app/jobs/job.h"
#include "io/archive/archive.h"
#include "io/archive/node_file.h"

#include <QObject>
#include <QStringList>

#include <optional>

namespace angiopose::ui {
class ArchiveDialog;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Brings studies and series from an archive into the cache, and says what became of them.
class ArchiveRetrieval : public QObject {
    Q_OBJECT
public:
    explicit ArchiveRetrieval(ui::ArchiveDialog& dialog, QObject* parent = nullptr);

    void start(const io::ArchiveNode& node, const io::ArchiveSettings& settings,
               const std::vector<io::RetrieveWish>& wishes);
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
                                     const std::vector<io::RetrieveWish>& wishes);
    void stop();
    void follow(const Progress& progress);
    void take(const io::TransferReport& report);

    ui::ArchiveDialog& dialog_;
    QStringList folders_;
    bool hasBegun_ = false;   ///< objects are on their way
    RetrievalJob job_;
};

}   // namespace angiopose::app
