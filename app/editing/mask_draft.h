#pragma once

#include "app/document/set_fields.h"
#include "core/imaging/mask_edit.h"

#include <QObject>

#include <memory>
#include <vector>

namespace angiopose::app {

/// Mask edited with brush and scissors, with a record of the lumens of the case that it matched. Changes only on the
/// GUI thread and not while a worker reads it; changes made meanwhile are queued.
class MaskDraft : public QObject {
    Q_OBJECT
public:
    explicit MaskDraft(std::shared_ptr<core::VoxelMask> mask) : mask_(std::move(mask)) {}

    const std::shared_ptr<core::VoxelMask>& mask() const { return mask_; }
    void apply(const core::MaskChange& change);   ///< immediately, or once no worker reads it
    void lendOut() { isLent_ = true; }   ///< call when a worker starts reading the draft
    void takeBack();
    bool isLent() const { return isLent_; }

    using Strokes = std::vector<int>;   ///< stroke numbers in the order in which the strokes were made
    int newStroke() { return ++lastStroke_; }   ///< returns a unique number
    void noteMade(int stroke);
    void noteUndone();
    const Strokes& strokes() const { return strokes_; }
    /// Records that the draft matched this lumen after these strokes; null stands for no lumen.
    void standFor(const std::shared_ptr<const core::VoxelMask>& lumen, const Strokes& strokes);
    /// Returns the number of strokes by which the draft differs from this lumen; empty if the draft never matched it.
    std::optional<int> strokesSince(const std::shared_ptr<const core::VoxelMask>& lumen) const;

signals:
    void touched(const core::TouchedBox& box);
    void strokesChanged();

private:
    struct Stand {
        std::weak_ptr<const core::VoxelMask> lumen;
        bool isNone = false;
        Strokes strokes;
    };
    std::shared_ptr<core::VoxelMask> mask_;
    std::vector<core::MaskChange> waiting_;
    std::vector<Stand> stands_;
    bool isLent_ = false;
    Strokes strokes_;
    int lastStroke_ = 0;
};

/// Undo step of one stroke or cut, which is already applied when it is pushed. Stores the changed voxels as runs.
class EditMask : public NamedEdit {
public:
    EditMask(CaseDocument& document, std::shared_ptr<MaskDraft> draft, core::MaskChange change, ui::Words name);
    void redo() override;
    void undo() override;

private:
    CaseDocument& document_;
    std::shared_ptr<MaskDraft> draft_;
    core::MaskChange change_;
    int stroke_;
    bool isMade_ = true;
};

}   // namespace angiopose::app
