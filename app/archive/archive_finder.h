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

/// What was found last, for a dialog that is opened again.
struct ArchiveFindings {
    QString node;
    std::optional<io::ArchiveMatches> studies;   ///< nothing: not searched yet
};

/// Searches an archive: studies, and series of a study that is unfolded.
class ArchiveFinder : public QObject {
    Q_OBJECT
public:
    ArchiveFinder(ui::ArchiveDialog& dialog, ArchiveFindings& findings, QAction& hideIdentity,
                  QObject* parent = nullptr);

    /// Searches go there from now on; what another one held is not shown any more.
    void follow(const std::optional<io::ArchiveNode>& node);
    std::vector<io::RetrieveRequest> requests() const;   ///< what is chosen, by study

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
    std::deque<QString> waiting_;   ///< studies whose series are wanted, the first one asked for
    Job<io::ArchiveMatches> studies_;
    Job<io::ArchiveMatches> series_;
};

}   // namespace angiopose::app
