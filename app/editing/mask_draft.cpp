#include "app/editing/mask_draft.h"

#include <utility>

namespace angiopose::app {

void MaskDraft::apply(const core::MaskChange& change)
{
    if (change.runs.empty()) {
        return;
    }
    if (isLent_) {
        waiting_.push_back(change);
        return;
    }
    core::flip(*mask_, change);
    emit touched(core::boxOf(mask_->geometry, change));
}

void MaskDraft::takeBack()
{
    isLent_ = false;
    for (const core::MaskChange& change : std::exchange(waiting_, {})) {
        apply(change);
    }
}

void MaskDraft::countStrokes(int by)
{
    strokes_ += by;
    emit strokesChanged();
}

void MaskDraft::standFor(const std::shared_ptr<const core::VoxelMask>& lumen, int strokes)
{
    stands_.push_back({lumen, lumen == nullptr, strokes});
}

std::optional<int> MaskDraft::strokesSince(const std::shared_ptr<const core::VoxelMask>& lumen) const
{
    for (const Stand& stand : stands_) {
        if (lumen ? stand.lumen.lock() == lumen : stand.isNone) {
            return std::abs(strokes_ - stand.strokes);
        }
    }
    return std::nullopt;
}

EditMask::EditMask(std::shared_ptr<MaskDraft> draft, core::MaskChange change, ui::Words name)
    : NamedEdit(std::move(name)), draft_(std::move(draft)), change_(std::move(change))
{
}

void EditMask::redo()
{
    if (!std::exchange(isMade_, false)) {
        draft_->apply(change_);
    }
    draft_->countStrokes(1);
}

void EditMask::undo()
{
    draft_->apply(change_);
    draft_->countStrokes(-1);
}

}   // namespace angiopose::app
