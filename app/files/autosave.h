#pragma once

#include "app/document/case_document.h"
#include "app/jobs/file_queue.h"

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

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

}   // namespace angiopose::app