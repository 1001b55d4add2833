#include "app/archive/archive_echo.h"

#include "app/archive/network_wait.h"
#include "ui/archive/transfer_line.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"

namespace angiopose::app {

ArchiveEcho::ArchiveEcho(ui::TransferLine& line, QObject* parent)
    : QObject(parent),
      line_(line),
      job_({[this](const core::Messages& notes) { tell(notes); },
            [this](const core::Error& error) { line_.showProblem(ui::messageText(error.message)); }})
{
    connect(&line_, &ui::TransferLine::stopRequested, this, [this] {
        if (job_.isRunning()) {
            job_.drop();   // what hangs is not waited for
            line_.showHint(tr("Stopped."));
        }
    });
}

void ArchiveEcho::ask(const io::ArchiveNode& node)
{
    name_ = QString::fromStdString(node.name);
    line_.showBusy(tr("Asking %1 …").arg(name_));
    job_.start([node](JobLink<double>& link) -> core::Result<core::Messages> {
        const NetworkWait waiting;
        const auto answered = io::echoArchive(node, io::ArchiveWay::Usual,
                                              [&link](const io::ArchiveProgress&) { return link.verdict(); });
        return answered ? core::Result<core::Messages>(io::connectionNotes(node)) : answered.error();
    });
}

void ArchiveEcho::tell(const core::Messages& notes)
{
    QStringList words{tr("%1 answers, and lets this program in.").arg(name_)};
    if (!notes.empty()) {
        words << ui::messagesText(notes);
    }
    line_.showDone(ui::joinedSentences(words));
}

}   // namespace angiopose::app
