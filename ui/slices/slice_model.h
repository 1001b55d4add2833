#pragma once

#include "core/imaging/mask_edit.h"
#include "core/imaging/slice_measurement.h"
#include "core/imaging/volume_slice.h"
#include "core/vessel/vessel_tree.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/slices/slice_image.h"

#include <QObject>
#include <QStringList>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::ui {

class SliceTool;

enum class SliceMarkKind { Seed, Avoid, Landmark, Place };

/// Point shown in the slices, optionally with a ring.
struct SliceMark {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();
    QString label;
    std::vector<Eigen::Vector3d> ring{};   ///< closed outline in patient mm, drawn where a slice intersects it

    bool operator==(const SliceMark&) const = default;
};

/// Measurement in a slice with its displayed label.
struct LabeledMeasurement {
    core::SliceMeasurement measurement;
    QString label;
    bool isSelected = false;

    bool operator==(const LabeledMeasurement&) const = default;
};

/// Labels of a label image, tinted in different colors in the slices.
struct LabelLayer {
    std::shared_ptr<const core::VoxelMask> rows;   ///< 1 + index into `tints`; larger values use the last tint
    std::vector<MaskTint> tints;
    QStringList names;   ///< one name per tint

    bool operator==(const LabelLayer&) const = default;
};

/// State shared by all slice views: the scan, the segmentation and the crosshair.
class SliceModel : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Sets scan and lumen, either of which may be null; without a scan, only the lumen is shown. A new scan centers
    /// the crosshair and resets window/level.
    void setScan(std::shared_ptr<const core::Volume> volume, std::shared_ptr<const core::VoxelMask> lumen);
    void setLabels(LabelLayer labels);   ///< shows labels in place of the lumen; empty `rows` shows the lumen again
    /// Shows a mask being edited in place of lumen and labels; null shows lumen and labels again.
    void setDraft(std::shared_ptr<const core::VoxelMask> draft);
    void notifyDraftChanged(const core::BoundingBox& box);   ///< reports that the draft changed inside `box`
    void setMaskOpacity(double opacity);   ///< opacity of the mask on a scan
    void setTree(std::shared_ptr<const core::VesselTree> tree);
    void setMarks(const BranchMarks& marks);
    void setPoints(SliceMarkKind kind, std::vector<SliceMark> points);   ///< replaces all points of this kind
    void setMeasurements(std::vector<LabeledMeasurement> measurementData);
    void setTool(SliceTool* tool);   ///< sets the tool for the left button in all slices; null for the crosshair
    void setCrosshair(const Eigen::Vector3d& pointInPatient);   ///< clamps the point to the scan
    void setWindow(const GrayWindow& window);
    void setPreviewFrom(std::optional<double> threshold);   ///< tints values at or above the threshold

    bool hasScan() const { return geometry() != nullptr; }
    const core::VolumeGeometry* geometry() const;   ///< geometry of the scan or lumen; null if there is neither
    const std::shared_ptr<const core::Volume>& volume() const { return volume_; }
    const std::shared_ptr<const core::VoxelMask>& lumen() const { return lumen_; }
    const core::VoxelMask* mask() const;   ///< mask that the slices tint
    /// Returns the stored mask for background work, never the draft, which changes in place.
    const std::shared_ptr<const core::VoxelMask>& sharedMask() const { return labels_.rows ? labels_.rows : lumen_; }
    std::vector<MaskTint> labelTints() const;   ///< tints of the labels; empty if the mask is the lumen
    double maskOpacity() const { return maskOpacity_; }
    QString labelNameAt(const Eigen::Vector3d& pointInPatient) const;   ///< empty outside all labels
    const core::VesselTree* tree() const { return tree_.get(); }
    const BranchMarks& marks() const { return marks_; }
    const std::map<SliceMarkKind, std::vector<SliceMark>>& points() const { return points_; }
    const std::vector<LabeledMeasurement>& measurementData() const { return measurements_; }
    SliceTool* tool() const { return tool_; }
    const Eigen::Vector3d& crosshair() const { return crosshair_; }
    const GrayWindow& window() const { return window_; }
    std::optional<double> previewFrom() const { return previewFrom_; }
    bool isHounsfield() const { return isHounsfield_; }   ///< true if the value range suggests CT

signals:
    void scanChanged();
    void maskChanged();   ///< emitted when lumen, labels or draft were replaced
    void maskEdited(const core::BoundingBox& box);   ///< emitted when the mask has changed in place, inside `box`
    void crosshairChanged();
    void appearanceChanged();   ///< emitted when the window or the threshold preview has changed
    void overlayChanged();   ///< emitted when branches, points or measurements have changed
    void toolChanged();
    void toolAppearanceChanged();   ///< emitted when the tool draws something else

private:
    std::shared_ptr<const core::Volume> volume_;
    std::shared_ptr<const core::VoxelMask> lumen_;
    std::shared_ptr<const core::VoxelMask> draft_;
    LabelLayer labels_;
    double maskOpacity_ = 0.28;
    std::shared_ptr<const core::VesselTree> tree_;
    BranchMarks marks_;
    std::map<SliceMarkKind, std::vector<SliceMark>> points_;
    std::vector<LabeledMeasurement> measurements_;
    SliceTool* tool_ = nullptr;
    Eigen::Vector3d crosshair_ = Eigen::Vector3d::Zero();
    GrayWindow window_;
    std::optional<double> previewFrom_;
    bool isHounsfield_ = false;
};

QString nameOf(core::BodyPlane plane);   ///< returns the translated name of the plane, for headings

struct WindowPreset {
    const char* name;   ///< translated in the context "ui::WindowPreset"
    GrayWindow window;
};
const std::vector<WindowPreset>& windowPresets();

/// Returns a window that covers most values of a scan.
GrayWindow autoWindow(const core::Volume& volume);

}   // namespace angiopose::ui
