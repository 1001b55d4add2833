#include "app/document/case_document.h"

#include <utility>

namespace angiopose::app {

CaseDocument::CaseDocument(QObject* parent) : QObject(parent)
{
    connect(this, &CaseDocument::changed, this, [this] { ++revision_; });
}

void CaseDocument::replace(core::Case opened, const QString& path)
{
    case_ = std::move(opened);
    path_ = path;
    ++caseNumber_;
    isNeverSaved_ = path.isEmpty() && !isEmpty();
    isRecovered_ = false;
    undoStack_.clear();
    trialStartIndex_ = 0;
    emit changed();
    emit stateChanged();
}

void CaseDocument::markSaved(const QString& path, const CaseState& written)
{
    if (written.caseNumber != caseNumber_) {
        return;   // another case has been opened in the meantime
    }
    path_ = path;
    isNeverSaved_ = false;
    isRecovered_ = false;
    if (written == state()) {
        undoStack_.setClean();
    } else {
        undoStack_.resetClean();   // no position on the undo stack is known to match the file
    }
    emit stateChanged();
}

void CaseDocument::markUnsaved()
{
    isNeverSaved_ = true;
    isRecovered_ = true;
    emit stateChanged();
}

bool CaseDocument::push(std::unique_ptr<QUndoCommand> edit)
{
    if (locked_) {
        emit editRefused();
        return false;
    }
    undoStack_.push(edit.release());
    return true;
}

void CaseDocument::undo()
{
    emit aboutToUndoOrRedo();
    if (!locked_ && canUndo()) {
        undoStack_.undo();
    }
}

void CaseDocument::redo()
{
    emit aboutToUndoOrRedo();
    if (!locked_) {
        undoStack_.redo();
    }
}

void CaseDocument::beginTrial(std::unique_ptr<QUndoCommand> edit)
{
    if (isInTrial() || locked_) {
        return;
    }
    trialStartIndex_ = undoStack_.index() + 1;   // set before push() emits signals, whose receivers read this index
    undoStack_.push(edit.release());
    emit stateChanged();
}

void CaseDocument::endTrial()
{
    if (!isInTrial()) {
        return;
    }
    {
        const QSignalBlocker quiet(this);   // suppresses the signals of the individual steps
        undoStack_.setIndex(std::exchange(trialStartIndex_, 0) - 1);
    }
    auto nothing = std::make_unique<QUndoCommand>();
    nothing->setObsolete(true);
    undoStack_.push(nothing.release());   // an obsolete command discards the redo steps and removes itself
    emit changed();
    emit stateChanged();
}

void CaseDocument::setLocked(bool locked)
{
    locked_ = locked;
    emit stateChanged();
}

}   // namespace angiopose::app
