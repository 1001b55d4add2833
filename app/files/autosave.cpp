#include "app/files/autosave.h"

#include "app/preferences/private_mode.h"
#include "io/case/case_file.h"
#include "io/case/overwrite_case.h"
#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/own_leftovers.h"
#include "io/vessel_tree_file.h"
#include "ui/words/message_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <optional>
#include <utility>

namespace angiopose::app {
namespace {

using namespace std::chrono_literals;

QDir dataFolder(const char* name)
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QLatin1Char('/') +
                      QLatin1String(name));
    folder.mkpath(QStringLiteral("."));
    QFile::setPermissions(folder.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    return folder;
}

QDir autosaveFolder()
{
    return dataFolder("autosave");
}

QString sidecarOf(const QString& path)
{
    return path + QStringLiteral(".origin");
}

/// Returns the path of the session's lock file, which is the same for a case and for vessels without an angiogram.
QString lockPath(const QString& path)
{
    const QFileInfo file(path);
    return file.dir().filePath(file.completeBaseName() + QStringLiteral(".angiopose.lock"));
}

QString vesselsBeside(const QString& casePath)
{
    const QFileInfo file(casePath);
    return file.dir().filePath(file.completeBaseName() + QStringLiteral(".vtp"));
}

core::Result<QString> write(const core::Case& snapshot, const QString& path, const QString& original)
{
    if (snapshot.vessels.tree && !snapshot.shown().angiogram) {
        const QString vessels = vesselsBeside(path);
        if (const core::Status written = io::writeVesselTree(*snapshot.vessels.tree, vessels.toStdString()); !written) {
            return written.error();
        }
        QFile::remove(path);   // an older copy of the case is obsolete once the angiogram has been removed
        return vessels;
    }
    if (const auto saved = io::saveCase(snapshot, path.toStdString()); !saved) {
        return saved.error();
    }
    QFile::remove(vesselsBeside(path));
    const core::Status origin = io::writeAtomically(sidecarOf(path).toStdString(),
                                                    original.toStdString() + '\n' + caseForExport(snapshot).title);
    return origin ? core::Result<QString>(path) : origin.error();
}

/// Removes partial files and the locks of killed sessions without a copy; the user decides what to do with copies.
void removeStaleFiles()
{
    const QDir folder = autosaveFolder();
    io::removeLeftoversOnce(folder.path().toStdString());
    for (const QFileInfo& lock : folder.entryInfoList({QStringLiteral("session-*.angiopose.lock")}, QDir::Files)) {
        const QString copy = lock.dir().filePath(lock.completeBaseName());
        if (!QFile::exists(copy) && !QFile::exists(vesselsBeside(copy))) {
            QLockFile stale(lock.filePath());
            stale.setStaleLockTime(0);
            stale.tryLock(0);   // on success, the lock's destructor removes the file
        }
    }
}

void removeCopy(const QString& path)
{
    QFile::remove(path);
    QFile::remove(sidecarOf(path));
    QFile::remove(vesselsBeside(path));
    QDir folder = QFileInfo(path).dir();
    const QString base = QFileInfo(path).completeBaseName();
    for (const QString& kept :   // edited curves and deformations of all views, and the edited mask
         folder.entryList({base + QStringLiteral(".*curves.csv"), base + QStringLiteral(".mask*.nrrd"),
                           base + QStringLiteral(".*bends*.nrrd")})) {
        folder.remove(kept);
    }
}

}   // namespace

Autosave::Autosave(const CaseDocument& document, QObject* parent)
    : QObject(parent), document_(document), lock_(std::make_unique<QLockFile>(lockPath(path())))
{
    lock_->setStaleLockTime(0);
    lock_->tryLock(0);
    files_.run(
        []() -> core::Result<QString> {
            removeStaleFiles();
            return QString();
        },
        {});
    timer_.setInterval(60s);
    connect(&timer_, &QTimer::timeout, this, &Autosave::saveSoon);
    timer_.start();
}

QString Autosave::path() const
{
    return autosaveFolder().filePath(QStringLiteral("session-%1.angiopose").arg(QCoreApplication::applicationPid()));
}

bool Autosave::needsAutosave() const
{
    const core::Case& current = document_.current();
    if (document_.isEmpty() || !document_.isModified() || document_.isInTrial()) {
        return false;
    }
    // Centerlines that were only opened are still in their file, but traced vessels would have to be computed again.
    return current.shown().angiogram || document_.hasUnsavedWork() ||
           current.vessels.input.kind != core::VesselInputKind::Centerline;
}

void Autosave::saveSoon()
{
    const int index = document_.undoStack().index();
    if (files_.isBusy() || !needsAutosave() || index == savedIndex_) {
        return;
    }
    savedIndex_ = index;
    files_.run([snapshot = document_.current(), path = path(),
                original = document_.path()] { return write(snapshot, path, original); },
               [this](const core::Result<QString>& written) { finishSave(written); });
}

void Autosave::finishSave(const core::Result<QString>& written)
{
    const bool wasFailing = std::exchange(isFailing_, !written);
    if (written) {
        lastSaved_ = QDateTime::currentDateTime();
        emit saved();
        return;
    }
    savedIndex_ = -1;   // tries again at the next interval
    if (!wasFailing) {
        emit failed(ui::messageText(written.error().message));
    }
}

void Autosave::discard()
{
    savedIndex_ = -1;
    files_.run(
        [path = path()]() -> core::Result<QString> {
            removeCopy(path);
            return path;
        },
        [this](const core::Result<QString>&) {
            lastSaved_.reset();
            isFailing_ = false;
        });
}

std::vector<RecoveryCopy> Autosave::recoveryCopies()
{
    std::vector<RecoveryCopy> copies;
    const QStringList names{QStringLiteral("session-*.angiopose"), QStringLiteral("session-*.vtp")};
    for (const QFileInfo& file : autosaveFolder().entryInfoList(names, QDir::Files)) {
        QLockFile lock(lockPath(file.absoluteFilePath()));
        lock.setStaleLockTime(0);
        if (!lock.tryLock(0)) {
            continue;   // the session is still running
        }
        QFile sidecar(sidecarOf(file.absoluteFilePath()));
        const QString origin = sidecar.open(QIODevice::ReadOnly) ? QString::fromUtf8(sidecar.readAll()) : QString();
        copies.push_back(
            {file.absoluteFilePath(), origin.section(u'\n', 0, 0), origin.section(u'\n', 1), file.lastModified()});
    }
    std::ranges::sort(copies, std::greater{}, &RecoveryCopy::savedAt);
    return copies;
}

void Autosave::forget(const RecoveryCopy& copy)
{
    removeCopy(copy.path);
}

QString Autosave::adoptVessels(const RecoveryCopy& copy)
{
    const QDir folder = dataFolder("recovered");
    const QString name = QStringLiteral("vessels-") + copy.savedAt.toString(QStringLiteral("yyyyMMdd-hhmmss"));
    QString kept = folder.filePath(name + QStringLiteral(".vtp"));
    for (int i = 2; QFile::exists(kept); ++i) {
        kept = folder.filePath(QStringLiteral("%1-%2.vtp").arg(name).arg(i));
    }
    return QFile::rename(copy.path, kept) ? kept : copy.path;
}

CaseFileGuard::CaseFileGuard(const CaseDocument& document, FileQueue& files, QObject* parent)
    : QObject(parent), document_(document), files_(files)
{
    connect(&document_, &CaseDocument::stateChanged, this, &CaseFileGuard::updateFromDocument);
}

std::function<core::Status()> CaseFileGuard::guardedSave(core::Case snapshot, const QString& path,
                                                         Overwrite replaced) const
{
    return [kept = fileState_, snapshot = std::move(snapshot), file = path.toStdString(), replaced]() -> core::Status {
        const bool isCompared = replaced == Overwrite::KnownContent && kept->path == file;
        const auto saved = io::overwriteCase(snapshot, file, isCompared ? kept->sha256 : std::string());
        if (!saved) {
            return saved.error();
        }
        kept->path = file;
        kept->sha256 = saved.value();
        return core::Done{};
    };
}

void CaseFileGuard::expectUnchangedSince(const QDateTime& savedAt)
{
    files_.run(
        [kept = fileState_, savedAt]() -> core::Result<QString> {
            const QFileInfo file(QString::fromStdString(kept->path));
            if (!kept->sha256.empty() && file.lastModified() > savedAt) {
                kept->sha256 = "changed since";   // a value that matches no hash
            }
            return file.filePath();
        },
        {});
}

/// Handles a change of the open case or of its path.
void CaseFileGuard::updateFromDocument()
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
        [kept = fileState_, holder, path = path_, isRead]() -> core::Result<QString> {
            const std::string file = path.toStdString();
            kept->lock = io::CaseLock();
            if (isRead) {
                kept->path = file;
                kept->sha256 = file.empty() ? std::string() : io::caseFileHash(file);
            }
            if (!file.empty()) {
                *holder = io::lockHolderOf(file);
                kept->lock = io::CaseLock(file);
            }
            return path;
        },
        [this, holder, path = path_](const core::Result<QString>&) {
            if (*holder && path == path_) {
                const std::string name = QFileInfo(path).fileName().toStdString();
                emit foundOpenElsewhere(ui::messageText(
                    io::messages::caseOpenElsewhere((*holder)->process, (*holder)->machine).about(name)));
            }
        });
}

}   // namespace angiopose::app
