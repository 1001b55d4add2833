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
struct Leftover {
    QString path;   ///< path of the autosaved copy
    QString original;   ///< path of the case file; empty: never saved
    QString title;   ///< title of the case; empty: not known
    QDateTime when;

    bool holdsVessels() const
    {
        return path.endsWith(QLatin1String(".vtp"));
    }   ///< vessels without an angiogram, not a case
};

/// Saves a copy of a modified case to the application's data folder every minute on a worker. Vessels without an
/// angiogram are saved as centerlines. A failed save is retried every minute.
class Autosave : public QObject {
    Q_OBJECT
public:
    explicit Autosave(const CaseDocument& document, QObject* parent = nullptr);

    void saveSoon();   ///< called by the timer and by tests
    void discard();   ///< removes the copy after save, close or discard; waits for a running write
    std::optional<QDateTime> lastSaved() const { return lastSaved_; }
    bool isFailing() const { return isFailing_; }   ///< the last attempt failed; an older copy may exist

    /// Lists the copies of sessions that are no longer running, newest first.
    static std::vector<Leftover> leftBehind();
    static void forget(const Leftover& copy);
    /// Moves recovered vessels to a permanent file that cases can refer to; returns its path.
    static QString keepVessels(const Leftover& copy);

signals:
    void saved();
    void failed(const QString& reason);   ///< emitted once until autosave works again

private:
    QString path() const;   ///< path for the case; vessels alone are saved next to it
    bool isWorthCopying() const;
    void take(const core::Result<QString>& written);

    const CaseDocument& document_;
    QTimer timer_;
    std::unique_ptr<QLockFile> lock_;
    std::optional<QDateTime> lastSaved_;
    bool isFailing_ = false;
    int savedIndex_ = -1;   ///< undo index that the copy holds
    FileQueue files_;
};

/// Coordinates access to the file of the open case with other windows and programs: locks it, informs the user who else
/// has it open, and knows which content a save may overwrite. Accesses files in the save queue, in its order.
class CaseKeeper : public QObject {
    Q_OBJECT
public:
    CaseKeeper(const CaseDocument& document, FileQueue& files, QObject* parent = nullptr);

    enum class Replaced { KnownContent, AnyContent };   ///< content that a save may overwrite

    /// Returns the job that writes a case; it fails without writing if another program has changed the file.
    std::function<core::Status()> saving(core::Case snapshot, const QString& path, Replaced replaced) const;

    /// Call for a case opened from a copy of that time: a later version of its file counts as changed elsewhere.
    void expectUnchangedSince(const QDateTime& when);

signals:
    void openElsewhere(const QString& words);   ///< the case just opened, saved or recovered is open elsewhere

private:
    /// Accessed only by jobs of the queue.
    struct Kept {
        std::string path;
        std::string sha256;   ///< hash of the file as opened or saved here
        io::CaseLock lock;
    };
    void follow();

    const CaseDocument& document_;
    FileQueue& files_;
    std::shared_ptr<Kept> kept_ = std::make_shared<Kept>();
    QString path_;
    int caseNumber_ = 0;
};

}   // namespace angiopose::app
