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

/// A case that a session left behind when it ended without closing.
struct LeftBehind {
    QString path;   ///< of the autosaved copy
    QString original;   ///< where the case lived; empty when it was never saved
    QString title;   ///< of the case; empty: not known
    QDateTime when;

    bool holdsVessels() const { return path.endsWith(QLatin1String(".vtp")); }   ///< without an angiogram: no case
};

/// Keeps a copy of a changed case in the application's data folder, every minute and on a worker. Vessels that have no
/// angiogram yet are kept as centrelines. What cannot be written is tried again every minute.
class Autosave : public QObject {
    Q_OBJECT
public:
    explicit Autosave(const CaseDocument& document, QObject* parent = nullptr);

    void saveSoon();   ///< for the timer and for tests
    void discard();   ///< the copy is no longer needed: saved, closed or discarded; goes once it is written
    std::optional<QDateTime> lastSaved() const { return lastSaved_; }
    bool isFailing() const { return isFailing_; }   ///< the last try; an older copy may be there

    /// Copies of sessions that are not alive any more, newest first.
    static std::vector<LeftBehind> leftBehind();
    static void forget(const LeftBehind& copy);
    /// Vessels get a file that stays, for cases refer to it; where it lies.
    static QString keepVessels(const LeftBehind& copy);

signals:
    void saved();
    void failed(const QString& reason);   ///< once, until it works again

private:
    QString path() const;   ///< of the case; vessels alone lie beside it
    bool isWorthCopying() const;
    void take(const core::Result<QString>& written);

    const CaseDocument& document_;
    QTimer timer_;
    std::unique_ptr<QLockFile> lock_;
    std::optional<QDateTime> lastSaved_;
    bool isFailing_ = false;
    int savedIndex_ = -1;   ///< undo position that the copy holds
    FileQueue files_;
};

/// Stands between the open case and whoever else has its file open: tells others that it is open here and the user who
/// else has it, and knows what content a save may replace. Looks at files by the queue that saves, in its order.
class CaseKeeper : public QObject {
    Q_OBJECT
public:
    CaseKeeper(const CaseDocument& document, FileQueue& files, QObject* parent = nullptr);

    enum class Replaced { KnownContent, AnyContent };   ///< what a save may write over

    /// Writes a case, when the queue comes to it: fails, nothing written, where another program has changed the file.
    std::function<core::Status()> saving(core::Case snapshot, const QString& path, Replaced replaced) const;

    /// The open case comes from a copy of that time: what was saved over its file later, this session does not know.
    void expectUnchangedSince(const QDateTime& when);

signals:
    void openElsewhere(const QString& words);   ///< the case that was just opened, saved or recovered

private:
    /// Used by work of the queue alone.
    struct Kept {
        std::string path;
        std::string sha256;   ///< of the file as it was opened or saved here
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
