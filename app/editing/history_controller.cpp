#include "app/editing/history_controller.h"

#include "app/document/set_fields.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/words/retranslation.h"

namespace angiopose::app {
namespace {

QString nameOf(const QUndoCommand* edit)
{
    const auto* named = dynamic_cast<const NamedEdit*>(edit);
    return named ? named->name() : edit ? edit->text() : QString();
}

}   // namespace

HistoryController::HistoryController(CaseDocument& document, ui::WindowActions& actions, ui::BottomStrip& strip,
                                     QObject* parent)
    : QObject(parent), document_(document), actions_(actions), strip_(strip)
{
    connect(actions[ui::Command::Undo], &QAction::triggered, &document_, &CaseDocument::undo);
    connect(actions[ui::Command::Redo], &QAction::triggered, &document_, &CaseDocument::redo);
    connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &HistoryController::show);
    connect(&document_, &CaseDocument::stateChanged, this, &HistoryController::show);
    ui::keepTranslated(this, [this] { show(); });
}

void HistoryController::show()
{
    const QUndoStack& stack = document_.undoStack();
    QAction* undo = actions_[ui::Command::Undo];
    QAction* redo = actions_[ui::Command::Redo];
    const bool canUndo = document_.canUndo();
    undo->setEnabled(canUndo);
    redo->setEnabled(stack.canRedo());
    undo->setText(canUndo ? tr("Undo: %1").arg(nameOf(stack.command(stack.index() - 1))) : tr("Undo"));
    redo->setText(stack.canRedo() ? tr("Redo: %1").arg(nameOf(stack.command(stack.index()))) : tr("Redo"));
    strip_.showUndoState(canUndo ? undo->text() : QString());
}

}   // namespace angiopose::app
