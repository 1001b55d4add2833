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
        const NetworkWait waiting;
        return io::findInArchive(node, io::ArchiveWay::Usual, query,
                                 [&link](const io::ArchiveProgress&) { return link.verdict(); });
    };
}

}   // namespace

ArchiveFinder::ArchiveFinder(ui::ArchiveDialog& dialog, ArchiveFindings& findings, QAction& hideIdentity,
                             QObject* parent)
    : QObject(parent),
      dialog_(dialog),
      findings_(findings),
      hideIdentity_(hideIdentity),
      studies_({[this](const io::ArchiveMatches& found) {
                    findings_ = {QString::fromStdString(node_->name), found};
                    show();
                    tell();
                },
                [this](const core::Error& error) { fail(error); }}),
      series_({[this](const io::ArchiveMatches& found) { takeSeries(found); },
               [this](const core::Error& error) {
                   dialog_.list().showNoSeries(waiting_.front());
                   waiting_.pop_front();
                   if (!dialog_.line().isBusy()) {
                       fail(error);
                   }
                   askNextSeries();
               }})
{
    dialog_.fields().showSearch(
        {{}, {}, settings::archiveFrom.read(), settings::archiveTo.read(), settings::archiveModality.read()});
    connect(&dialog_.fields(), &ui::SearchFields::searchRequested, this, &ArchiveFinder::find);
    connect(&dialog_.line(), &ui::TransferLine::stopRequested, this, [this] {
        if (studies_.isRunning()) {
            studies_.drop();   // abandons the query instead of waiting for an unresponsive archive
            dialog_.line().showHint(tr("Stopped."));
        }
    });
    connect(&dialog_.list(), &ui::MatchList::seriesWanted, this, &ArchiveFinder::askSeries);
    connect(&hideIdentity_, &QAction::toggled, this, &ArchiveFinder::show);
}

void ArchiveFinder::follow(const std::optional<io::ArchiveNode>& node)
{
    const bool isSame = node_ && node && node_->name == node->name;
    node_ = node;
    if (isSame) {
        return;
    }
    if (!node_ || findings_.node != QString::fromStdString(node_->name)) {
        findings_ = {};
    }
    show();
    if (node_ && !findings_.studies) {
        dialog_.line().showHint(tr("Search, select studies or series, then retrieve them."));
    }
}

void ArchiveFinder::find()
{
    const ui::ArchiveSearch search = dialog_.fields().search();
    if (const auto wrong = wrongDateOf(search)) {
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
    studies_.start(findWork(*node_, queryOf(search)));
}

void ArchiveFinder::show()
{
    waiting_.clear();
    series_.drop();
    showEmptyWords();
    dialog_.list().showStudies(findings_.studies ? studyMatchRows(findings_.studies->found, hideIdentity_.isChecked()
                                                                                                ? MatchIdentity::Hidden
                                                                                                : MatchIdentity::Shown)
                                                 : std::vector<ui::MatchRow>());
    dialog_.showState();
}

void ArchiveFinder::showEmptyWords()
{
    if (!node_) {
        return;   // the dialog already reports that no archive is selected
    }
    const QString name = QString::fromStdString(node_->name);
    dialog_.list().setEmptyWords(
        findings_.studies
            ? tr("%1 has no matching study. Broaden the search: a shorter name, more days, any modality.").arg(name)
            : tr("Search to list the studies on %1.").arg(name));
}

void ArchiveFinder::tell()
{
    const std::size_t count = findings_.studies->found.size();
    QStringList words{count == 1 ? tr("1 study found.") : tr("%1 studies found.").arg(count)};
    if (count > 0) {
        words << tr("Select studies, or expand one to select its series; Ctrl selects several.");
    }
    if (!findings_.studies->warnings.empty()) {
        words << ui::messagesText(findings_.studies->warnings);
    }
    dialog_.line().showDone(ui::joinedSentences(words));
    if (count > 0) {
        dialog_.list().setFocus();
    }
}

void ArchiveFinder::fail(const core::Error& error)
{
    dialog_.line().showProblem(ui::messageText(error.message));
}

void ArchiveFinder::askSeries(const QString& study)
{
    waiting_.push_back(study);
    if (waiting_.size() == 1) {
        askNextSeries();
    }
}

void ArchiveFinder::askNextSeries()
{
    if (!waiting_.empty() && node_) {
        io::ArchiveQuery query;
        query.level = io::ArchiveLevel::Series;
        query.studyUid = waiting_.front().toStdString();
        series_.start(findWork(*node_, query));
    }
}

void ArchiveFinder::takeSeries(const io::ArchiveMatches& series)
{
    dialog_.list().showSeries(waiting_.front(), seriesMatchRows(series.found));
    waiting_.pop_front();
    askNextSeries();
}

/// Requests a selected study as a whole, even if some of its series are selected too.
std::vector<io::RetrieveRequest> ArchiveFinder::requests() const
{
    std::vector<io::RetrieveRequest> requests;
    for (const auto& [study, series] : dialog_.list().chosen()) {
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
