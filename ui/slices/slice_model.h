#pragma once

#include "core/imaging/mask_edit.h"
#include "core/imaging/slice_measurement.h"
#include "core/imaging/volume_slice.h"
#include "core/vessel/vessel_tree.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/slices/slice_picture.h"

#include <QObject>
#include <QStringList>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::ui {

class SliceTool;

enum class SliceMarkKind { Seed, Avoid, Landmark, Place };

/// A point to show in the slices, or a ring around it.
struct SliceMark {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();
    QString label;
    std::vector<Eigen::Vector3d> ring{};   ///< points around it, closed; drawn where slices cut it

    bool operator==(const SliceMark&) const = default;
};

/// Something measured, with its value.
struct MeasuredSlice {
    core::SliceMeasurement measurement;
    QString label;
    bool isChosen = false;

    bool operator==(const MeasuredSlice&) const = default;
};

/// The labels of a label image, to be told apart in the slices.
struct LabelLayer {
    std::shared_ptr<const core::VoxelMask> rows;   ///< 1 + the place of a voxel's label below; the last for all beyond
    std::vector<MaskTint> tints;
    QStringList names;   ///< as many as tints

    bool operator==(const LabelLayer&) const = default;
};

/// What all slice views show in common: the scan, what was traced in it, and the cross-hair that links them.
class SliceModel : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Either may be null; without a scan the lumen is shown alone. A new scan puts the cross-hair in its middle and
    /// chooses the window.
    void setScan(std::shared_ptr<const core::Volume> volume, std::shared_ptr<const core::VoxelMask> lumen);
    void setLabels(LabelLayer labels);   ///< shown instead of the lumen; without rows that is shown again
    /// A mask that is being edited, shown instead of lumen and labels; null: these again.
    void setDraft(std::shared_ptr<const core::VoxelMask> draft);
    void touchDraft(const core::TouchedBox& box);   ///< it changed there
    void setMaskOpacity(double opacity);   ///< over a scan
    void setTree(std::shared_ptr<const core::VesselTree> tree);
    void setMarks(const BranchMarks& marks);
    void setPoints(SliceMarkKind kind, std::vector<SliceMark> points);   ///< replaces those of this kind
    void setMeasured(std::vector<MeasuredSlice> measured);
    void setTool(SliceTool* tool);   ///< what the left button does in all slices; null: the cross-hair
    void setCrosshair(const Eigen::Vector3d& pointInPatient);   ///< kept within the scan
    void setWindow(const GrayWindow& window);
    void setPreviewFrom(std::optional<double> threshold);   ///< tints what is not below it

    bool hasScan() const { return geometry() != nullptr; }
    const core::VolumeGeometry* geometry() const;   ///< of the scan, or of the lumen; null without either
    const std::shared_ptr<const core::Volume>& volume() const { return volume_; }
    const std::shared_ptr<const core::VoxelMask>& lumen() const { return lumen_; }
    const core::VoxelMask* mask() const;   ///< to be tinted
    /// The mask as it is kept, not one that is being edited (that changes in place): for work beside the window.
    const std::shared_ptr<const core::VoxelMask>& sharedMask() const { return labels_.rows ? labels_.rows : lumen_; }
    std::vector<MaskTint> labelTints() const;   ///< empty: the mask is the lumen
    double maskOpacity() const { return maskOpacity_; }
    QString labelNameAt(const Eigen::Vector3d& pointInPatient) const;   ///< empty where none is
    const core::VesselTree* tree() const { return tree_.get(); }
    const BranchMarks& marks() const { return marks_; }
    const std::map<SliceMarkKind, std::vector<SliceMark>>& points() const { return points_; }
    const std::vector<MeasuredSlice>& measured() const { return measured_; }
    SliceTool* tool() const { return tool_; }
    const Eigen::Vector3d& crosshair() const { return crosshair_; }
    const GrayWindow& window() const { return window_; }
    std::optional<double> previewFrom() const { return previewFrom_; }
    bool isHounsfield() const { return isHounsfield_; }   ///< the values look like those of CT

signals:
    void scanChanged();
    void maskChanged();   ///< labels or what is edited instead of the lumen, or back
    void maskTouched(const core::TouchedBox& box);   ///< the same mask, changed there
    void crosshairChanged();
    void lookChanged();   ///< window, preview
    void overlayChanged();   ///< branches, points, measurements
    void toolChanged();
    void toolLookChanged();   ///< what the tool paints

private:
    std::shared_ptr<const core::Volume> volume_;
    std::shared_ptr<const core::VoxelMask> lumen_;
    std::shared_ptr<const core::VoxelMask> draft_;
    LabelLayer labels_;
    double maskOpacity_ = 0.28;
    std::shared_ptr<const core::VesselTree> tree_;
    BranchMarks marks_;
    std::map<SliceMarkKind, std::vector<SliceMark>> points_;
    std::vector<MeasuredSlice> measured_;
    SliceTool* tool_ = nullptr;
    Eigen::Vector3d crosshair_ = Eigen::Vector3d::Zero();
    GrayWindow window_;
    std::optional<double> previewFrom_;
    bool isHounsfield_ = false;
};

QString nameOf(core::BodyPlane plane);   ///< as a heading

/// A named window of CT.
struct WindowPreset {
    const char* name;   ///< to be translated in "ui::WindowPreset"
    GrayWindow window;
};
const std::vector<WindowPreset>& windowPresets();

/// The window that shows most of a scan's values.
GrayWindow windowOfValues(const core::Volume& volume);

}   // namespace angiopose::ui