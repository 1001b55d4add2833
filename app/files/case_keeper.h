#pragma once

#include "app/document/case_document.h"
#include "app/jobs/file_queue.h"
#include "core/support/result.h"
#include "io/support/case_lock.h"

#include <QDateTime>
#include <QObject>

#include <memory>
#include <string>

namespace angiopose::app {

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
