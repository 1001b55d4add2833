#pragma once

#include "app/document/case_document.h"
#include "app/jobs/file_queue.h"
#include "core/support/result.h"
#include "io/support/case_lock.h"

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>

namespace angiopose::app {

/// Autosaved copy left by a session that did not close normally.
struct RecoveryCopy {
    QString path;   ///< path of the autosaved copy
    QString original;   ///< path of the case file; empty if the case was never saved
    QString title;   ///< title of the case; empty if unknown
    QDateTime savedAt;

    bool isVesselsOnly() const
    {
        return path.endsWith(QLatin1String(".vtp"));
    }   ///< true if the copy holds vessels without an angiogram, which are not a case
};

/// Saves a copy of a modified case to the application's data folder every minute on a worker. Saves vessels without an
/// angiogram as centerlines. Retries a failed save a minute later.
class Autosave : public QObject {
    Q_OBJECT
public:
    explicit Autosave(const CaseDocument& document, QObject* parent = nullptr);

    void saveSoon();   ///< called by the timer and by tests
    void discard();   ///< removes the copy after saving, closing or discarding; first waits for a write in progress
    std::optional<QDateTime> lastSaved() const { return lastSaved_; }
    bool isFailing() const { return isFailing_; }   ///< true if the last attempt failed; an older copy may exist

    /// Lists the copies of sessions that are no longer running, newest first.
    static std::vector<RecoveryCopy> recoveryCopies();
    static void forget(const RecoveryCopy& copy);
    /// Moves recovered vessels to a permanent file, to which cases can refer, and returns its path.
    static QString adoptVessels(const RecoveryCopy& copy);

signals:
    void saved();
    void failed(const QString& reason);   ///< emitted once per series of failed attempts

private:
    QString path() const;   ///< path of the case copy; vessels without an angiogram are saved next to it
    bool needsAutosave() const;
    void finishSave(const core::Result<QString>& written);

    const CaseDocument& document_;
    QTimer timer_;
    std::unique_ptr<QLockFile> lock_;
    std::optional<QDateTime> lastSaved_;
    bool isFailing_ = false;
    int savedIndex_ = -1;   ///< undo index at which the copy was saved
    FileQueue files_;
};

/// Coordinates access to the file of the open case with other windows and programs: locks the file, informs the user
/// who else has it open, and determines which contents a save may overwrite. All file access runs in the save queue.
class CaseFileGuard : public QObject {
    Q_OBJECT
public:
    CaseFileGuard(const CaseDocument& document, FileQueue& files, QObject* parent = nullptr);

    enum class Overwrite { KnownContent, AnyContent };   ///< contents that a save may overwrite

    /// Returns the job that writes a case. The job fails without writing if another program has changed the file.
    std::function<core::Status()> guardedSave(core::Case snapshot, const QString& path, Overwrite replaced) const;

    /// Call for a case recovered from a copy written at `savedAt`; a newer file counts as changed by another program.
    void expectUnchangedSince(const QDateTime& savedAt);

signals:
    void foundOpenElsewhere(const QString& note);   ///< the case just opened, saved or recovered is open elsewhere

private:
    /// Accessed only by jobs of the queue.
    struct FileState {
        std::string path;
        std::string sha256;   ///< hash of the file when this program last opened or saved it
        io::CaseLock lock;
    };
    void updateFromDocument();

    const CaseDocument& document_;
    FileQueue& files_;
    std::shared_ptr<FileState> fileState_ = std::make_shared<FileState>();
    QString path_;
    int caseNumber_ = 0;
};

}   // namespace angiopose::app
