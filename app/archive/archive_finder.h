#pragma once

#include "app/jobs/job.h"
#include "io/archive/archive.h"

#include <QHash>
#include <QObject>

#include <deque>
#include <optional>

class QAction;

namespace angiopose::ui {
class ArchiveDialog;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Matches of the last search, kept so that reopening the dialog shows them again.
struct ArchiveFindings {
    QString node;
    std::optional<io::ArchiveMatches> studies;   ///< empty before the first search
};

/// Searches an archive for studies, and for the series of an expanded study.
class ArchiveFinder : public QObject {
    Q_OBJECT
public:
    ArchiveFinder(ui::ArchiveDialog& dialog, ArchiveFindings& findings, QAction& hideIdentity,
                  QObject* parent = nullptr);

    /// Selects the archive to search and clears the matches of any other archive.
    void follow(const std::optional<io::ArchiveNode>& node);
    std::vector<io::RetrieveRequest> requests() const;   ///< selected items, one request per study

private:
    void find();
    void show();
    void tell();
    void askSeries(const QString& study);
    void askNextSeries();
    void takeSeries(const io::ArchiveMatches& series);
    void fail(const core::Error& error);
    void showEmptyWords();

    ui::ArchiveDialog& dialog_;
    ArchiveFindings& findings_;
    QAction& hideIdentity_;
    std::optional<io::ArchiveNode> node_;
    std::deque<QString> waiting_;   ///< studies whose series are still to be queried, oldest request first
    Job<io::ArchiveMatches> studies_;
    Job<io::ArchiveMatches> series_;
};

}   // namespace angiopose::app
