#pragma once

#include "app/document/set_fields.h"
#include "core/imaging/mask_edit.h"

#include <QObject>

#include <memory>
#include <vector>

namespace angiopose::app {

/// Mask edited with brush and scissors, with a record of the lumens of the case that it has matched. Changes only on
/// the GUI thread and not while a worker reads the mask; changes made meanwhile are queued.
class MaskDraft : public QObject {
    Q_OBJECT
public:
    explicit MaskDraft(std::shared_ptr<core::VoxelMask> mask) : mask_(std::move(mask)) {}

    const std::shared_ptr<core::VoxelMask>& mask() const { return mask_; }
    void apply(const core::MaskChange& change);   ///< applied immediately, or once no worker reads the draft
    void beginReading() { isBeingRead_ = true; }   ///< call when a worker starts reading the draft
    void endReading();
    bool isBeingRead() const { return isBeingRead_; }

    using Strokes = std::vector<int>;   ///< stroke numbers in the order in which the strokes were made
    int newStroke() { return ++lastStroke_; }   ///< returns a unique number
    void addStroke(int stroke);
    void removeStroke();
    const Strokes& strokes() const { return strokes_; }
    /// Records that the draft matched this lumen after these strokes; null stands for no lumen.
    void recordMatch(const std::shared_ptr<const core::VoxelMask>& lumen, const Strokes& strokes);
    /// Returns the number of strokes by which the draft differs from this lumen; nullopt if the draft never matched it.
    std::optional<int> strokesSince(const std::shared_ptr<const core::VoxelMask>& lumen) const;

signals:
    void voxelsChanged(const core::BoundingBox& box);
    void strokesChanged();

private:
    struct LumenMatch {
        std::weak_ptr<const core::VoxelMask> lumen;
        bool hasNoLumen = false;
        Strokes strokes;
    };
    std::shared_ptr<core::VoxelMask> mask_;
    std::vector<core::MaskChange> pendingChanges_;
    std::vector<LumenMatch> matches_;
    bool isBeingRead_ = false;
    Strokes strokes_;
    int lastStroke_ = 0;
};

/// Undo step of one stroke or cut, which is already applied when it is pushed. Stores the voxels in run-length form.
class EditMask : public NamedEdit {
public:
    EditMask(CaseDocument& document, std::shared_ptr<MaskDraft> draft, core::MaskChange change, ui::LocalizedText name);
    void redo() override;
    void undo() override;

private:
    CaseDocument& document_;
    std::shared_ptr<MaskDraft> draft_;
    core::MaskChange change_;
    int stroke_;
    bool isApplied_ = true;
};

}   // namespace angiopose::app
