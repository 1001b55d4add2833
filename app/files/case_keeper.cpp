#include "app/files/case_keeper.h"

#include "io/case/save_over.h"
#include "io/messages/says_keeping.h"
#include "ui/words/message_text.h"

#include <QFileInfo>

#include <optional>
#include <utility>

namespace angiopose::app {

CaseKeeper::CaseKeeper(const CaseDocument& document, FileQueue& files, QObject* parent)
    : QObject(parent), document_(document), files_(files)
{
    connect(&document_, &CaseDocument::stateChanged, this, &CaseKeeper::follow);
}

std::function<core::Status()> CaseKeeper::saving(core::Case snapshot, const QString& path, Replaced replaced) const
{
    return [kept = kept_, snapshot = std::move(snapshot), file = path.toStdString(), replaced]() -> core::Status {
        const bool isCompared = replaced == Replaced::KnownContent && kept->path == file;
        const auto saved = io::saveCaseOver(snapshot, file, isCompared ? kept->sha256 : std::string());
        if (!saved) {
            return saved.error();
        }
        kept->path = file;
        kept->sha256 = saved.value();
        return core::Done{};
    };
}

void CaseKeeper::expectUnchangedSince(const QDateTime& when)
{
    files_.run(
        [kept = kept_, when]() -> core::Result<QString> {
            const QFileInfo file(QString::fromStdString(kept->path));
            if (!kept->sha256.empty() && file.lastModified() > when) {
                kept->sha256 = "changed since";   // the hash of nothing
            }
            return file.filePath();
        },
        {});
}

/// Another case, or another file of this one.
void CaseKeeper::follow()
{
    const int caseNumber = document_.state().caseNumber;
    const bool isRead = caseNumber != caseNumber_;
    if (!isRead && document_.path() == path_) {
        return;
    }
    caseNumber_ = caseNumber;
    path_ = document_.path();
    const auto holder = std::make_shared<std::optional<io::LockHolder>>();
    files_.run(
        [kept = kept_, holder, path = path_, isRead]() -> core::Result<QString> {
            const std::string file = path.toStdString();
            kept->lock = io::CaseLock();
            if (isRead) {
                kept->path = file;
                kept->sha256 = file.empty() ? std::string() : io::contentOfCaseFile(file);
            }
            if (!file.empty()) {
                *holder = io::holderOf(file);
                kept->lock = io::CaseLock(file);
            }
            return path;
        },
        [this, holder, path = path_](const core::Result<QString>&) {
            if (*holder && path == path_) {
                const std::string name = QFileInfo(path).fileName().toStdString();
                emit openElsewhere(
                    ui::messageText(io::says::caseOpenElsewhere((*holder)->process, (*holder)->machine).about(name)));
            }
        });
}

}   // namespace angiopose::app
