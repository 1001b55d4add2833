#include "app/archive/archive_nodes.h"

#include "app/archive/archive_settings.h"
#include "app/archive/archive_words.h"
#include "app/archive/network_wait.h"
#include "ui/archive/node_dialog.h"
#include "ui/archive/send_dialog.h"
#include "ui/archive/transfer_line.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"

#include <algorithm>

namespace angiopose::app {
namespace {

void dropNode(std::vector<io::ArchiveNode>& nodes, const std::string& name)
{
    std::erase_if(nodes, [&name](const io::ArchiveNode& node) { return node.name == name; });
}

/// Replaces the node named `former`, or appends the new one if there is none.
void putNode(std::vector<io::ArchiveNode>& nodes, const io::ArchiveNode& node, const std::string& former)
{
    const auto place = std::ranges::find(nodes, former, &io::ArchiveNode::name);
    if (former.empty() || place == nodes.end()) {
        nodes.push_back(node);
    } else {
        *place = node;
    }
}

}   // namespace

ArchiveEcho::ArchiveEcho(ui::TransferLine& line, QObject* parent)
    : QObject(parent),
      statusRow_(line),
      job_({[this](const core::Messages& notes) { showEchoResult(notes); },
            [this](const core::Error& error) { statusRow_.showProblem(ui::messageText(error.message)); }})
{
    connect(&statusRow_, &ui::TransferLine::stopRequested, this, [this] {
        if (job_.isRunning()) {
            job_.drop();   // abandons the test rather than waiting for an unresponsive archive
            statusRow_.showHint(tr("Stopped."));
        }
    });
}

void ArchiveEcho::sendEcho(const io::ArchiveNode& node)
{
    name_ = QString::fromStdString(node.name);
    statusRow_.showBusy(tr("Contacting %1…").arg(name_));
    job_.start([node](JobLink<double>& link) -> core::Result<core::Messages> {
        const ThreadPoolRelease waiting;
        const auto answered = io::echoArchive(node, io::ArchiveProtocol::Default,
                                              [&link](const io::ArchiveProgress&) { return link.decision(); });
        return answered ? core::Result<core::Messages>(io::connectionWarnings(node)) : answered.error();
    });
}

void ArchiveEcho::showEchoResult(const core::Messages& notes)
{
    QStringList words{tr("%1 responded and accepted the connection.").arg(name_)};
    if (!notes.empty()) {
        words << ui::messagesText(notes);
    }
    statusRow_.showDone(ui::joinSentences(words));
}

ArchiveNodes::ArchiveNodes(ArchiveList& list, const Ui& ui, QObject* parent)
    : QObject(parent), list_(list), ui_(ui), echo_(ui.line)
{
    connect(&list_, &ArchiveList::changed, this, &ArchiveNodes::show);
    connect(&list_, &ArchiveList::failed, this, [this](const QString& reason) { ui_.line.showProblem(reason); });
    connect(&ui_.bar, &ui::NodeBar::nodeChosen, this, [this](const QString& name) {
        settings::archiveNode.write(name);
        emit archiveSelected();
    });
    connect(&ui_.bar, &ui::NodeBar::testRequested, this, &ArchiveNodes::test);
    connect(&ui_.bar, &ui::NodeBar::addRequested, this, &ArchiveNodes::add);
    connect(&ui_.bar, &ui::NodeBar::editRequested, this, &ArchiveNodes::edit);
    connect(&ui_.bar, &ui::NodeBar::removeRequested, this, &ArchiveNodes::confirmRemoval);
}

std::optional<io::ArchiveNode> ArchiveNodes::node() const
{
    return list_.node(ui_.bar.node());
}

void ArchiveNodes::show()
{
    ui_.bar.showNodes(list_.names(), settings::archiveNode.read());
    emit archiveSelected();
}

void ArchiveNodes::test()
{
    if (const auto asked = node()) {
        echo_.sendEcho(*asked);
    }
}

void ArchiveNodes::add()
{
    openDialog({}, {});
}

void ArchiveNodes::edit()
{
    if (const auto edited = node()) {
        openDialog(toArchiveEntry(*edited), ui_.bar.node());
    }
}

void ArchiveNodes::openDialog(const ui::ArchiveEntry& entry, const QString& former)
{
    using ui::NodeDialog;
    editor_ =
        new NodeDialog(entry, former.isEmpty() ? NodeDialog::Purpose::Add : NodeDialog::Purpose::Edit, &ui_.dialog);
    auto* echo = new ArchiveEcho(editor_->line(), editor_);
    connect(editor_, &NodeDialog::testRequested, echo, [this, echo](const ui::ArchiveEntry& tested) {
        const io::ArchiveNode node = toArchiveNode(tested);
        if (const auto checked = io::checkNode(node); checked) {
            echo->sendEcho(node);
        } else {
            editor_->line().showProblem(ui::messageText(checked.error().message));
        }
    });
    connect(editor_, &NodeDialog::saveRequested, this,
            [this, former](const ui::ArchiveEntry& wanted) { save(wanted, former); });
    editor_->open();
}

void ArchiveNodes::save(const ui::ArchiveEntry& entry, const QString& former)
{
    const io::ArchiveNode node = toArchiveNode(entry);
    if (const auto checked = io::checkNode(node); !checked) {
        editor_->line().showProblem(ui::messageText(checked.error().message));
        return;
    }
    if (entry.name != former && list_.node(entry.name)) {
        editor_->line().showProblem(tr("A PACS with this name already exists. Choose another name."));
        return;
    }
    settings::archiveNode.write(entry.name);
    list_.change(
        [node, former = former.toStdString()](io::ArchiveSettings& settings) -> core::Status {
            putNode(settings.nodes, node, former);
            return core::Done{};
        },
        [editor = editor_](const std::optional<core::Message>& problem) {
            if (editor && problem) {
                editor->line().showProblem(ui::messageText(*problem));
            } else if (editor) {
                editor->accept();
            }
        });
}

void ArchiveNodes::confirmRemoval()
{
    const QString name = ui_.bar.node();
    auto* question = new ui::QuestionDialog({tr("Remove %1 from the list?").arg(name),
                                             tr("The PACS itself and the objects retrieved from it are not affected."),
                                             {}},
                                            {tr("Remove"), tr("Cancel")}, &ui_.dialog);
    question->setObjectName(QStringLiteral("archiveRemoval"));
    connect(question, &ui::QuestionDialog::answered, this, [this, name](int index) {
        if (index == 0) {
            list_.change(
                [name = name.toStdString()](io::ArchiveSettings& settings) -> core::Status {
                    dropNode(settings.nodes, name);
                    return core::Done{};
                },
                [line = QPointer(&ui_.line)](const std::optional<core::Message>& problem) {
                    if (line && problem) {
                        line->showProblem(ui::messageText(*problem));
                    }
                });
        }
    });
    question->open();
}

}   // namespace angiopose::app
