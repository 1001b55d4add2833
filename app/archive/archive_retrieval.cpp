#include "app/archive/archive_retrieval.h"

#include "app/archive/archive_words.h"
#include "app/archive/network_wait.h"
#include "app/preferences/save_folder.h"
#include "io/archive/store/cache.h"
#include "io/sharing/audit_file.h"
#include "ui/archive/archive_dialog.h"
#include "ui/archive/receive_line.h"
#include "ui/archive/transfer_line.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"

#include <QLocale>
#include <QPointer>
#include <utility>

namespace angiopose::app {
namespace {

/// Adds the report of one study to the running total.
void add(io::TransferReport& sum, const io::TransferReport& part)
{
    sum.all += part.all;
    sum.transferred += part.transferred;
    sum.duplicates += part.duplicates;
    sum.failed += part.failed;
    sum.bytes += part.bytes;
    sum.folders.insert(sum.folders.end(), part.folders.begin(), part.folders.end());
    for (const core::Message& problem : part.problems) {
        sum.addProblem(problem);
    }
    sum.end = part.end;
}

QString numbered(std::size_t number)
{
    return QLocale().toString(static_cast<qulonglong>(number));
}

std::uint64_t bytesIn(const std::string& folder)
{
    std::uint64_t bytes = 0;
    for (const io::CachedSeries& series : io::listCachedSeries(folder)) {
        bytes += series.bytes;
    }
    return bytes;
}

}   // namespace

ArchiveRetrieval::ArchiveRetrieval(ui::ArchiveDialog& dialog, QObject* parent)
    : QObject(parent),
      dialog_(dialog),
      job_({[this](const RetrievalOutcome& came) {
                if (came.auditFailed) {
                    emit auditFailed(ui::messageText(*came.auditFailed));
                }
                showReport(came.report);
            },
            [this](const core::Error& error) {
                dialog_.line().showProblem(ui::messageText(error.message));
                emit ended();
            },
            [this](const Progress& progress) { follow(progress); }})
{
    connect(&dialog_.line(), &ui::TransferLine::stopRequested, this, &ArchiveRetrieval::stop);
}

ArchiveRetrieval::RetrievalJob::Work ArchiveRetrieval::makeRetrieval(const io::ArchiveNode& node,
                                                                     const io::ArchiveSettings& settings,
                                                                     const std::vector<io::RetrieveRequest>& requests)
{
    const std::string audit = auditPath().toStdString();
    return [node, settings, requests, audit](JobLink<Progress>& link) -> core::Result<RetrievalOutcome> {
        const ThreadPoolRelease waiting;
        const auto store = io::ObjectStore::open(settings.cache(), io::defaultMaxObjectBytes);
        if (!store) {
            return store.error();
        }
        io::StoreLimit limit;
        limit.maxBytes = settings.cacheBytes;
        io::TransferReport sum;
        for (std::size_t i = 0; i < requests.size() && !sum.end; ++i) {
            const auto observe = [&](const io::ArchiveProgress& progress) {
                return link.tell({progress, i + 1, requests.size()});
            };
            add(sum, io::retrieveFromArchive(node, io::ArchiveProtocol::Default, requests[i], store.value(), limit,
                                             observe));
        }
        // The worker writes the audit entries rather than the receiver of the outcome: the dialog may be closed by
        // then, but the retrieved objects stay in the cache.
        io::AuditBatch batch(audit, {io::AuditEvent::Retrieved, "angiopose", {}, node.name});
        for (const std::string& folder : sum.folders) {
            batch.add(folder);
        }
        batch.flush();
        return RetrievalOutcome{std::move(sum), batch.problem()};
    };
}

void ArchiveRetrieval::start(const io::ArchiveNode& node, const io::ArchiveSettings& settings,
                             const std::vector<io::RetrieveRequest>& requests)
{
    hasReceived_ = false;
    dialog_.offerPartialSeries(false);
    dialog_.line().showBusy(tr("Contacting %1…").arg(QString::fromStdString(node.name)));
    job_.start(makeRetrieval(node, settings, requests));
}

/// Stops the retrieval. If no object has arrived yet, abandons the job rather than waiting for an unresponsive archive.
void ArchiveRetrieval::stop()
{
    if (!job_.isRunning()) {
        return;
    }
    if (hasReceived_) {
        job_.requestStop();
        dialog_.line().showBusy(tr("Stopping…"));
    } else {
        job_.drop();
        dialog_.line().showHint(tr("Stopped."));
        emit ended();
    }
}

void ArchiveRetrieval::follow(const Progress& progress)
{
    if (progress.archive.all == 0) {
        return;
    }
    hasReceived_ = true;
    QString words = tr("%1 of %2 objects, %3")
                        .arg(numbered(progress.archive.objects), numbered(progress.archive.all),
                             byteSizeText(progress.archive.bytes));
    if (progress.studies > 1) {
        words = tr("Study %1 of %2: %3").arg(numbered(progress.study), numbered(progress.studies), words);
    }
    dialog_.line().showProgress(words, static_cast<qsizetype>(progress.archive.objects),
                                static_cast<qsizetype>(progress.archive.all));
}

/// Handles the final report. A canceled retrieval keeps the objects received so far; the next one fetches the rest.
void ArchiveRetrieval::showReport(const io::TransferReport& report)
{
    folders_.clear();
    for (const std::string& folder : report.folders) {
        folders_ << QString::fromStdString(folder);
    }
    const std::size_t came = report.transferred + report.duplicates;
    const QString count = tr("%1 of %2 objects were retrieved.").arg(numbered(came), numbered(report.all));
    if (report.isComplete()) {
        dialog_.line().showDone(count);
        emit ended();
        emit retrieved();
        return;
    }
    if (report.end && report.end->isCancellation()) {
        dialog_.line().showHint(ui::joinSentences({tr("Stopped."), count, tr("Retrieve again to get the rest.")}));
    } else {
        QStringList words{report.end ? ui::messageText(report.end->message) : problemSummary(report.problems)};
        dialog_.line().showProblem(ui::joinSentences(words << count));
    }
    dialog_.offerPartialSeries(came > 0);
    emit ended();
}

ArchiveCache::ArchiveCache(ArchiveList& list, const Ui& ui, QObject* parent)
    : QObject(parent),
      list_(list),
      ui_(ui),
      measureJob_([this](const std::uint64_t& bytes) {
          usedBytes_ = bytes;
          ui_.line.showCache(bytes == 0 ? tr("empty") : byteSizeText(bytes), bytes == 0,
                             static_cast<double>(list_.settings().cacheBytes) / 1e9,
                             QString::fromStdString(list_.settings().cache()));
      }),
      emptyJob_({[this](const std::size_t& dropped) {
                     ui_.words.showDone(tr("Cache emptied. Objects deleted: %1.").arg(dropped));
                     measure();
                 },
                 [this](const core::Error& error) {
                     ui_.words.showProblem(ui::messageText(error.message));
                     measure();
                 }})
{
    connect(&list_, &ArchiveList::changed, this, &ArchiveCache::measure);
    connect(&ui_.line, &ui::CacheLine::limitChosen, this, &ArchiveCache::limit,
            Qt::QueuedConnection);   // the Return key that commits the limit must not also accept the next dialog
    connect(&ui_.line, &ui::CacheLine::emptyRequested, this, &ArchiveCache::confirmEmptying);
}

void ArchiveCache::measure()
{
    measureJob_.start([folder = list_.settings().cache()](JobLink<double>&) -> core::Result<std::uint64_t> {
        return bytesIn(folder);
    });
}

void ArchiveCache::limit(double gigabytes)
{
    const auto bytes = static_cast<std::uint64_t>(gigabytes * 1e9);
    if (bytes < usedBytes_) {
        confirmLowerLimit(bytes);
    } else {
        setLimit(bytes);
    }
}

/// Asks for confirmation before setting a limit below the current size, because a typing error would delete objects.
void ArchiveCache::confirmLowerLimit(std::uint64_t bytes)
{
    auto* question = new ui::QuestionDialog(
        {tr("Reduce the cache below its current size?"),
         tr("The cache contains %1. The least recently used objects will be deleted until %2 remain.")
             .arg(byteSizeText(usedBytes_), byteSizeText(bytes)),
         {}},
        {tr("Delete"), tr("Cancel")}, &ui_.dialog);
    question->setObjectName(QStringLiteral("cacheDropping"));
    connect(question, &ui::QuestionDialog::answered, this, [this, bytes](int index) {
        if (index == 0) {
            setLimit(bytes);
        } else {
            measure();   // restores the previous limit in the field
        }
    });
    question->open();
}

void ArchiveCache::setLimit(std::uint64_t bytes)
{
    list_.change(
        [bytes](io::ArchiveSettings& settings) -> core::Status {
            settings.cacheBytes = bytes;
            io::shrinkCache(settings.cache(), bytes);
            return core::Done{};
        },
        [words = QPointer(&ui_.words)](const std::optional<core::Message>& problem) {
            if (words && problem) {
                words->showProblem(ui::messageText(*problem));
            }
        });
}

void ArchiveCache::confirmEmptying()
{
    auto* question = new ui::QuestionDialog(
        {tr("Empty the cache?"),
         tr("All retrieved objects will be deleted. When you open a case whose images were in the cache, AngioPose "
            "will ask for the location of the images. “Share case as ZIP” keeps case and images together."),
         {}},
        {tr("Empty"), tr("Cancel")}, &ui_.dialog);
    question->setObjectName(QStringLiteral("cacheEmptying"));
    connect(question, &ui::QuestionDialog::answered, this, [this](int index) {
        if (index == 0) {
            empty();
        }
    });
    question->open();
}

void ArchiveCache::empty()
{
    ui_.words.showBusy(tr("Emptying the cache…"));
    emptyJob_.start([folder = list_.settings().cache()](JobLink<double>&) { return io::clearCache(folder); });
}

}   // namespace angiopose::app
