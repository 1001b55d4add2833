#include "app/document/case_document.h"

#include <utility>

namespace app {

CaseDocument::CaseDocument(QObject* parent) : QObject(parent)
{
    connect(this, &CaseDocument::changed, this, [this] { ++revision_; });
}

void CaseDocument::replace(core::RegistrationCase opened, const QString& path)
{
    case_ = std::move(opened);
    path_ = path;
    ++caseNumber_;
    unsavedByNature_ = path.isEmpty() && !isEmpty();
    undoStack_.clear();
    emit changed();
    emit stateChanged();
}

void CaseDocument::markSaved(const QString& path, const CaseState& written)
{
    if (written.caseNumber != caseNumber_) {
        return;   // another case has been opened since
    }
    path_ = path;
    unsavedByNature_ = false;
    if (written == state()) {
        undoStack_.setClean();
    } else {
        undoStack_.resetClean();   // no position of the stack is known to match the file
    }
    emit stateChanged();
}

void CaseDocument::markUnsaved()
{
    unsavedByNature_ = true;
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

void CaseDocument::setLocked(bool locked)
{
    locked_ = locked;
    emit stateChanged();
}

}   // namespace app
