#include "app/archive/archive_finder.h"

#include "app/archive/archive_settings.h"
#include "app/archive/archive_words.h"
#include "app/archive/network_wait.h"
#include "ui/archive/archive_dialog.h"
#include "ui/archive/match_list.h"
#include "ui/archive/search_fields.h"
#include "ui/archive/send_dialog.h"
#include "ui/archive/transfer_line.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"

#include <QAction>

#include <algorithm>

namespace angiopose::app {
namespace {

Job<io::ArchiveMatches>::Work findWork(const io::ArchiveNode& node, const io::ArchiveQuery& query)
{
    return [node, query](JobLink<double>& link) {
        const ThreadPoolRelease waiting;
        return io::queryArchive(node, io::ArchiveProtocol::Default, query,
                                [&link](const io::ArchiveProgress&) { return link.decision(); });
    };
}

}   // namespace

ArchiveFinder::ArchiveFinder(ui::ArchiveDialog& dialog, ArchiveSearchResults& findings, QAction& hideIdentity,
                             QObject* parent)
    : QObject(parent),
      dialog_(dialog),
      searchResults_(findings),
      hideIdentity_(hideIdentity),
      studies_({[this](const io::ArchiveMatches& found) {
                    searchResults_ = {QString::fromStdString(node_->name), found};
                    show();
                    showStatus();
                },
                [this](const core::Error& error) { showError(error); }}),
      series_({[this](const io::ArchiveMatches& found) { showSeriesMatches(found); },
               [this](const core::Error& error) {
                   dialog_.list().markSeriesUnloaded(pendingStudies_.front());
                   pendingStudies_.pop_front();
                   if (!dialog_.line().isBusy()) {
                       showError(error);
                   }
                   queryNextSeries();
               }})
{
    dialog_.fields().showSearch(
        {{}, {}, settings::archiveFrom.read(), settings::archiveTo.read(), settings::archiveModality.read()});
    connect(&dialog_.fields(), &ui::SearchFields::searchRequested, this, &ArchiveFinder::find);
    connect(&dialog_.line(), &ui::TransferLine::stopRequested, this, [this] {
        if (studies_.isRunning()) {
            studies_.drop();   // abandons the query rather than waiting for an unresponsive archive
            dialog_.line().showHint(tr("Stopped."));
        }
    });
    connect(&dialog_.list(), &ui::MatchList::seriesRequested, this, &ArchiveFinder::querySeries);
    connect(&hideIdentity_, &QAction::toggled, this, &ArchiveFinder::show);
}

void ArchiveFinder::selectArchive(const std::optional<io::ArchiveNode>& node)
{
    const bool isSame = node_ && node && node_->name == node->name;
    node_ = node;
    if (isSame) {
        return;
    }
    if (!node_ || searchResults_.node != QString::fromStdString(node_->name)) {
        searchResults_ = {};
    }
    show();
    if (node_ && !searchResults_.studies) {
        dialog_.line().showHint(tr("Search, select studies or series, then retrieve them."));
    }
}

void ArchiveFinder::find()
{
    const ui::ArchiveSearch search = dialog_.fields().search();
    if (const auto wrong = firstInvalidDate(search)) {
        dialog_.line().showProblem(tr("“%1” is not a date. Enter year, month and day: 2024-01-31.").arg(*wrong));
        return;
    }
    if (!node_) {
        return;
    }
    settings::archiveFrom.write(search.from);
    settings::archiveTo.write(search.to);
    settings::archiveModality.write(search.modality);
    dialog_.line().showBusy(tr("Searching %1…").arg(QString::fromStdString(node_->name)));
    studies_.start(findWork(*node_, toArchiveQuery(search)));
}

void ArchiveFinder::show()
{
    pendingStudies_.clear();
    series_.drop();
    showNoMatches();
    dialog_.list().showStudies(searchResults_.studies
                                   ? studyMatchRows(searchResults_.studies->found, hideIdentity_.isChecked()
                                                                                       ? IdentityVisibility::Hidden
                                                                                       : IdentityVisibility::Shown)
                                   : std::vector<ui::MatchRow>());
    dialog_.showState();
}

void ArchiveFinder::showNoMatches()
{
    if (!node_) {
        return;   // the dialog already reports that no archive is selected
    }
    const QString name = QString::fromStdString(node_->name);
    dialog_.list().setPlaceholderText(searchResults_.studies ? tr("%1 has no matching study. Broaden the search: use a "
                                                                  "shorter name, a wider date range or any modality.")
                                                                   .arg(name)
                                                             : tr("Search to list the studies in %1.").arg(name));
}

void ArchiveFinder::showStatus()
{
    const std::size_t count = searchResults_.studies->found.size();
    QStringList words{count == 1 ? tr("1 study found.") : tr("%1 studies found.").arg(count)};
    if (count > 0) {
        words << tr("Select studies, or expand one to select its series; Ctrl selects several.");
    }
    if (!searchResults_.studies->warnings.empty()) {
        words << ui::messagesText(searchResults_.studies->warnings);
    }
    dialog_.line().showDone(ui::joinSentences(words));
    if (count > 0) {
        dialog_.list().setFocus();
    }
}

void ArchiveFinder::showError(const core::Error& error)
{
    dialog_.line().showProblem(ui::messageText(error.message));
}

void ArchiveFinder::querySeries(const QString& study)
{
    pendingStudies_.push_back(study);
    if (pendingStudies_.size() == 1) {
        queryNextSeries();
    }
}

void ArchiveFinder::queryNextSeries()
{
    if (!pendingStudies_.empty() && node_) {
        io::ArchiveQuery query;
        query.level = io::ArchiveLevel::Series;
        query.studyUid = pendingStudies_.front().toStdString();
        series_.start(findWork(*node_, query));
    }
}

void ArchiveFinder::showSeriesMatches(const io::ArchiveMatches& series)
{
    dialog_.list().showSeries(pendingStudies_.front(), seriesMatchRows(series.found));
    pendingStudies_.pop_front();
    queryNextSeries();
}

/// Requests a selected study as a whole, even if some of its series are also selected.
std::vector<io::RetrieveRequest> ArchiveFinder::requests() const
{
    std::vector<io::RetrieveRequest> requests;
    for (const auto& [study, series] : dialog_.list().selection()) {
        auto request = std::ranges::find(requests, study.toStdString(), &io::RetrieveRequest::studyUid);
        const bool isNew = request == requests.end();
        if (isNew) {
            request = requests.insert(request, {study.toStdString(), {}});
        }
        if (series.isEmpty()) {
            request->seriesUids.clear();
        } else if (isNew || !request->seriesUids.empty()) {
            request->seriesUids.push_back(series.toStdString());
        }
    }
    return requests;
}

}   // namespace angiopose::app
