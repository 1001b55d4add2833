#include "app/editing/mask_draft.h"

#include <algorithm>
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

void MaskDraft::noteMade(int stroke)
{
    strokes_.push_back(stroke);
    emit strokesChanged();
}

void MaskDraft::noteUndone()
{
    strokes_.pop_back();
    emit strokesChanged();
}

void MaskDraft::standFor(const std::shared_ptr<const core::VoxelMask>& lumen, const Strokes& strokes)
{
    stands_.push_back({lumen, lumen == nullptr, strokes});
}

std::optional<int> MaskDraft::strokesSince(const std::shared_ptr<const core::VoxelMask>& lumen) const
{
    for (const Stand& stand : stands_) {
        if (lumen ? stand.lumen.lock() == lumen : stand.isNone) {
            const auto [own, its] = std::ranges::mismatch(strokes_, stand.strokes);
            return static_cast<int>((strokes_.end() - own) + (stand.strokes.end() - its));
        }
    }
    return std::nullopt;
}

EditMask::EditMask(CaseDocument& document, std::shared_ptr<MaskDraft> draft, core::MaskChange change, ui::Words name)
    : NamedEdit(std::move(name)),
      document_(document),
      draft_(std::move(draft)),
      change_(std::move(change)),
      stroke_(draft_->newStroke())
{
}

void EditMask::redo()
{
    if (!std::exchange(isMade_, false)) {
        draft_->apply(change_);
    }
    draft_->noteMade(stroke_);
    document_.noteChange();
}

void EditMask::undo()
{
    draft_->apply(change_);
    draft_->noteUndone();
    document_.noteChange();
}

}   // namespace angiopose::app
