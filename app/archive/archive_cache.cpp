#include "app/archive/archive_cache.h"

#include "app/archive/archive_words.h"
#include "io/archive/store/cache.h"
#include "ui/archive/receive_line.h"
#include "ui/archive/transfer_line.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/words/message_text.h"

#include <QPointer>

namespace angiopose::app {
namespace {

std::uint64_t bytesIn(const std::string& folder)
{
    std::uint64_t bytes = 0;
    for (const io::CachedSeries& series : io::cachedSeries(folder)) {
        bytes += series.bytes;
    }
    return bytes;
}

}   // namespace

ArchiveCache::ArchiveCache(ArchiveList& list, const Ui& ui, QObject* parent)
    : QObject(parent),
      list_(list),
      ui_(ui),
      measuring_([this](const std::uint64_t& bytes) {
          held_ = bytes;
          ui_.line.showCache(bytes == 0 ? tr("empty") : sizeWords(bytes), bytes == 0,
                             static_cast<double>(list_.settings().cacheBytes) / 1e9,
                             QString::fromStdString(list_.settings().cache()));
      }),
      emptying_({[this](const std::size_t& dropped) {
                     ui_.words.showDone(tr("The cache is empty. Objects dropped: %1.").arg(dropped));
                     measure();
                 },
                 [this](const core::Error& error) {
                     ui_.words.showProblem(ui::messageText(error.message));
                     measure();
                 }})
{
    connect(&list_, &ArchiveList::changed, this, &ArchiveCache::measure);
    connect(&ui_.line, &ui::CacheLine::limitChosen, this, &ArchiveCache::limit,
            Qt::QueuedConnection);   // the Return that commits must not answer what is asked then
    connect(&ui_.line, &ui::CacheLine::emptyRequested, this, &ArchiveCache::askEmptying);
}

void ArchiveCache::measure()
{
    measuring_.start([folder = list_.settings().cache()](JobLink<double>&) -> core::Result<std::uint64_t> {
        return bytesIn(folder);
    });
}

void ArchiveCache::limit(double gigabytes)
{
    const auto bytes = static_cast<std::uint64_t>(gigabytes * 1e9);
    if (bytes < held_) {
        askDropping(bytes);
    } else {
        setLimit(bytes);
    }
}

/// Less than is held: a slip of the finger must not drop anything.
void ArchiveCache::askDropping(std::uint64_t bytes)
{
    auto* question = new ui::QuestionDialog(
        {tr("Keep less than is there?"),
         tr("The cache holds %1. What was not used for the longest time is dropped until %2 are left.")
             .arg(sizeWords(held_), sizeWords(bytes)),
         {}},
        {tr("Drop"), tr("Cancel")}, &ui_.dialog);
    question->setObjectName(QStringLiteral("cacheDropping"));
    connect(question, &ui::QuestionDialog::answered, this, [this, bytes](int index) {
        if (index == 0) {
            setLimit(bytes);
        } else {
            measure();   // shows the former limit
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

void ArchiveCache::askEmptying()
{
    auto* question = new ui::QuestionDialog(
        {tr("Empty the cache?"),
         tr("All that was retrieved is dropped. Cases whose images lie there ask for them when they are opened; "
            "“Pack case for others” keeps case and images together."),
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
    ui_.words.showBusy(tr("Emptying the cache …"));
    emptying_.start([folder = list_.settings().cache()](JobLink<double>&) { return io::emptyCache(folder); });
}

}   // namespace angiopose::app
