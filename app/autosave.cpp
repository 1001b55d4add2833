#include "app/autosave.h"

#include "app/jobs/guarded.h"
#include "io/case_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QtConcurrentRun>

#include <algorithm>

namespace app {
namespace {

using namespace std::chrono_literals;

QDir autosaveFolder()
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                      QStringLiteral("/autosave"));
    folder.mkpath(QStringLiteral("."));
    return folder;
}

QString sidecarOf(const QString& path)
{
    return path + QStringLiteral(".origin");
}

QString lockOf(const QString& path)
{
    return path + QStringLiteral(".lock");
}

core::Status write(const core::RegistrationCase& snapshot, const QString& path, const QString& original)
{
    auto saved = io::saveCase(snapshot, path.toStdString());
    if (saved) {
        QFile sidecar(sidecarOf(path));
        if (sidecar.open(QIODevice::WriteOnly)) {
            sidecar.write(original.toUtf8());
        }
    }
    return saved;
}

}   // namespace

Autosave::Autosave(const CaseDocument& document, QObject* parent)
    : QObject(parent), document_(document), lock_(std::make_unique<QLockFile>(lockOf(path())))
{
    lock_->setStaleLockTime(0);
    lock_->tryLock(0);
    timer_.setInterval(60s);
    connect(&timer_, &QTimer::timeout, this, &Autosave::saveSoon);
    connect(&writer_, &QFutureWatcherBase::finished, this, [this] {
        if (writer_.result()) {
            lastSaved_ = QDateTime::currentDateTime();
            emit saved();
        }
    });
    timer_.start();
}

Autosave::~Autosave()
{
    writer_.waitForFinished();
}

QString Autosave::path() const
{
    return autosaveFolder().filePath(QStringLiteral("session-%1.angiopose").arg(QCoreApplication::applicationPid()));
}

void Autosave::saveSoon()
{
    const int index = document_.undoStack().index();
    if (writer_.isRunning() || document_.isEmpty() || !document_.isModified() || index == savedIndex_) {
        return;
    }
    savedIndex_ = index;
    writer_.setFuture(QtConcurrent::run(
        [snapshot = document_.current(), path = path(), original = document_.path()]() -> core::Status {
            return guarded<core::Done>([&] { return write(snapshot, path, original); });
        }));
}

void Autosave::discard()
{
    writer_.waitForFinished();
    QFile::remove(path());
    QFile::remove(sidecarOf(path()));
    lastSaved_.reset();
    savedIndex_ = -1;
}

std::vector<LeftBehind> Autosave::leftBehind()
{
    std::vector<LeftBehind> copies;
    for (const QFileInfo& file : autosaveFolder().entryInfoList({QStringLiteral("session-*.angiopose")}, QDir::Files)) {
        QLockFile lock(lockOf(file.absoluteFilePath()));
        lock.setStaleLockTime(0);
        if (!lock.tryLock(0)) {
            continue;   // that session is alive
        }
        QFile sidecar(sidecarOf(file.absoluteFilePath()));
        const QString original = sidecar.open(QIODevice::ReadOnly) ? QString::fromUtf8(sidecar.readAll()) : QString();
        copies.push_back({file.absoluteFilePath(), original, file.lastModified()});
    }
    std::ranges::sort(copies, std::greater{}, &LeftBehind::when);
    return copies;
}

void Autosave::forget(const LeftBehind& copy)
{
    QFile::remove(copy.path);
    QFile::remove(sidecarOf(copy.path));
}

}   // namespace app
