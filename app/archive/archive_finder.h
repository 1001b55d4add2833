#pragma once

#include "app/jobs/job.h"
#include "io/archive/archive.h"

#include <QObject>

#include <deque>
#include <optional>

class QAction;

namespace angiopose::ui {
class ArchiveDialog;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Matches of the last search, kept so that reopening the dialog shows them again.
struct ArchiveSearchResults {
    QString node;
    std::optional<io::ArchiveMatches> studies;   ///< nullopt before the first search
};

/// Searches an archive for studies, and for the series of an expanded study.
class ArchiveFinder : public QObject {
    Q_OBJECT
public:
    ArchiveFinder(ui::ArchiveDialog& dialog, ArchiveSearchResults& findings, QAction& hideIdentity,
                  QObject* parent = nullptr);

    /// Selects the archive to search and clears the matches of any other archive.
    void selectArchive(const std::optional<io::ArchiveNode>& node);
    std::vector<io::RetrieveRequest> requests() const;   ///< selected items, combined into one request per study

private:
    void find();
    void show();
    void showStatus();
    void querySeries(const QString& study);
    void queryNextSeries();
    void showSeriesMatches(const io::ArchiveMatches& series);
    void showError(const core::Error& error);
    void showNoMatches();

    ui::ArchiveDialog& dialog_;
    ArchiveSearchResults& searchResults_;
    QAction& hideIdentity_;
    std::optional<io::ArchiveNode> node_;
    std::deque<QString> pendingStudies_;   ///< studies whose series are still to be queried, oldest request first
    Job<io::ArchiveMatches> studies_;
    Job<io::ArchiveMatches> series_;
};

}   // namespace angiopose::app
