#include "app/case_document.h"

#include <utility>

namespace app {

void CaseDocument::replace(core::RegistrationCase opened, const QString& path)
{
    case_ = std::move(opened);
    path_ = path;
    unsavedByNature_ = path.isEmpty() && !isEmpty();
    undoStack_.clear();
    emit changed();
    emit stateChanged();
}

void CaseDocument::markSaved(const QString& path)
{
    path_ = path;
    unsavedByNature_ = false;
    undoStack_.setClean();
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
