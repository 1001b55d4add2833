#include "app/editing/mask_draft.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {

void MaskDraft::apply(const core::MaskChange& change)
{
    if (change.runs.empty()) {
        return;
    }
    if (isBeingRead_) {
        pendingChanges_.push_back(change);
        return;
    }
    core::flip(*mask_, change);
    emit voxelsChanged(core::boxOf(mask_->geometry, change));
}

void MaskDraft::endReading()
{
    isBeingRead_ = false;
    for (const core::MaskChange& change : std::exchange(pendingChanges_, {})) {
        apply(change);
    }
}

void MaskDraft::addStroke(int stroke)
{
    strokes_.push_back(stroke);
    emit strokesChanged();
}

void MaskDraft::removeStroke()
{
    strokes_.pop_back();
    emit strokesChanged();
}

void MaskDraft::recordMatch(const std::shared_ptr<const core::VoxelMask>& lumen, const Strokes& strokes)
{
    matches_.push_back({lumen, lumen == nullptr, strokes});
}

std::optional<int> MaskDraft::strokesSince(const std::shared_ptr<const core::VoxelMask>& lumen) const
{
    for (const LumenMatch& stand : matches_) {
        if (lumen ? stand.lumen.lock() == lumen : stand.hasNoLumen) {
            const auto [own, its] = std::ranges::mismatch(strokes_, stand.strokes);
            return static_cast<int>((strokes_.end() - own) + (stand.strokes.end() - its));
        }
    }
    return std::nullopt;
}

EditMask::EditMask(CaseDocument& document, std::shared_ptr<MaskDraft> draft, core::MaskChange change,
                   ui::LocalizedText name)
    : NamedEdit(std::move(name)),
      document_(document),
      draft_(std::move(draft)),
      change_(std::move(change)),
      stroke_(draft_->newStroke())
{
}

void EditMask::redo()
{
    if (!std::exchange(isApplied_, false)) {
        draft_->apply(change_);
    }
    draft_->addStroke(stroke_);
    document_.notifyChanged();
}

void EditMask::undo()
{
    draft_->apply(change_);
    draft_->removeStroke();
    document_.notifyChanged();
}

}   // namespace angiopose::app
