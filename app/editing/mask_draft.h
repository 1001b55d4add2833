#pragma once

#include "app/document/set_fields.h"
#include "core/imaging/mask_edit.h"

#include <QObject>

#include <memory>
#include <vector>

namespace angiopose::app {

/// A mask under brush and scissors, and which lumens of the case it stands for. It changes on the window's thread
/// alone, and not while a worker reads it: what comes then waits.
class MaskDraft : public QObject {
    Q_OBJECT
public:
    explicit MaskDraft(std::shared_ptr<core::VoxelMask> mask) : mask_(std::move(mask)) {}

    const std::shared_ptr<core::VoxelMask>& mask() const { return mask_; }
    void apply(const core::MaskChange& change);   ///< at once, or when nobody reads it any more
    void lendOut() { isLent_ = true; }   ///< a worker reads it
    void takeBack();
    bool isLent() const { return isLent_; }

    using Strokes = std::vector<int>;   ///< by their numbers, in the order in which they were made
    int newStroke() { return ++lastStroke_; }   ///< a number of its own
    void noteMade(int stroke);
    void noteUndone();
    const Strokes& strokes() const { return strokes_; }
    /// The lumen was copied from it, or it from the lumen, when these strokes had been made; null: no lumen.
    void standFor(const std::shared_ptr<const core::VoxelMask>& lumen, const Strokes& strokes);
    /// How many strokes it has more or less than that lumen; nothing: it does not stand for it.
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

/// One stroke or cut as a step of undo. It was made before it is pushed. Keeps the voxels that changed, in runs.
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
