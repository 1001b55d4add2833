#include "ui/slices/slice_model.h"

#include "ui/slices/slice_tool.h"

#include <algorithm>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr std::size_t sampledVoxels = 40000;
constexpr double airHu = -500.0;   // only air in CT has lower values

/// Returns values sampled at regular intervals from the whole scan, in ascending order.
std::vector<double> sampledValues(const core::Volume& volume)
{
    const std::size_t count = volume.voxels.size();
    const std::size_t step = std::max<std::size_t>(1, count / sampledVoxels) | 1U;   // odd, to sample varying columns
    std::vector<double> values;
    for (std::size_t i = 0; i < count; i += step) {
        values.push_back(volume.value(i));
    }
    std::ranges::sort(values);
    return values;
}

}   // namespace

const std::vector<WindowPreset>& windowPresets()
{
    static const std::vector<WindowPreset> presets{
        {QT_TRANSLATE_NOOP("angiopose::ui::WindowPreset", "CTA"), {600.0, 200.0}},
        {QT_TRANSLATE_NOOP("angiopose::ui::WindowPreset", "Bone"), {2000.0, 500.0}},
        {QT_TRANSLATE_NOOP("angiopose::ui::WindowPreset", "Soft tissue"), {400.0, 40.0}},
        {QT_TRANSLATE_NOOP("angiopose::ui::WindowPreset", "Lung"), {1500.0, -600.0}},
    };
    return presets;
}

QString nameOf(core::BodyPlane plane)
{
    switch (plane) {
        case core::BodyPlane::Axial:
            return SliceModel::tr("Axial");
        case core::BodyPlane::Coronal:
            return SliceModel::tr("Coronal");
        default:
            return SliceModel::tr("Sagittal");
    }
}

GrayWindow autoWindow(const core::Volume& volume)
{
    const std::vector<double> values = sampledValues(volume);
    if (values.empty()) {
        return {};
    }
    const double low = values[values.size() / 50];
    const double high = values[values.size() - 1 - values.size() / 200];
    return {std::max(high - low, 1.0), 0.5 * (low + high)};
}

void SliceModel::setScan(std::shared_ptr<const core::Volume> volume, std::shared_ptr<const core::VoxelMask> lumen)
{
    if (volume == volume_ && lumen == lumen_) {
        return;
    }
    const core::VolumeGeometry* before = geometry();
    const core::VolumeGeometry previous = before ? *before : core::VolumeGeometry{};   // empty if there was no scan
    const bool isNewVolume = volume != volume_;
    volume_ = std::move(volume);
    lumen_ = std::move(lumen);
    if (isNewVolume && volume_) {
        const std::vector<double> values = sampledValues(*volume_);
        isHounsfield_ = !values.empty() && values.front() < airHu;
        window_ = isHounsfield_ ? windowPresets().front().window : autoWindow(*volume_);
    }
    const core::VolumeGeometry* updated = geometry();
    const bool isSamePlace = updated && core::isSameGrid(previous, *updated);
    if (updated && !isSamePlace) {
        crosshair_ = core::centerOf(*updated);
    }
    if (isSamePlace && !isNewVolume) {
        emit maskChanged();   // unlike scanChanged, keeps zoom and position
    } else {
        emit scanChanged();
    }
}

void SliceModel::setLabels(LabelLayer labels)
{
    if (labels == labels_) {
        return;
    }
    const bool isOtherMask = labels.rows != labels_.rows;
    labels_ = std::move(labels);
    if (isOtherMask) {
        emit maskChanged();
    }
    emit appearanceChanged();
}

void SliceModel::setDraft(std::shared_ptr<const core::VoxelMask> draft)
{
    if (draft != draft_) {
        draft_ = std::move(draft);
        emit maskChanged();
    }
}

void SliceModel::notifyDraftChanged(const core::BoundingBox& box)
{
    if (draft_) {
        emit maskEdited(box);
    }
}

void SliceModel::setMaskOpacity(double opacity)
{
    if (opacity != maskOpacity_) {
        maskOpacity_ = opacity;
        emit appearanceChanged();
    }
}

const core::VoxelMask* SliceModel::mask() const
{
    return draft_ ? draft_.get() : labels_.rows ? labels_.rows.get() : lumen_.get();
}

std::vector<MaskTint> SliceModel::labelTints() const
{
    return draft_ ? std::vector<MaskTint>() : labels_.tints;
}

QString SliceModel::labelNameAt(const Eigen::Vector3d& pointInPatient) const
{
    if (draft_ || !labels_.rows || labels_.names.isEmpty()) {
        return {};
    }
    const core::VolumeGeometry& geometry = labels_.rows->geometry;
    const Eigen::Vector3d at = geometry.patientFromVoxel().inverse() * pointInPatient;
    const Eigen::Vector3i voxel = (at.array() + 0.5).floor().cast<int>();
    const int row = geometry.contains(voxel) ? labels_.rows->at(voxel.x(), voxel.y(), voxel.z()) : 0;
    return row > 0 ? labels_.names[std::min<qsizetype>(row, labels_.names.size()) - 1] : QString();
}

void SliceModel::setTree(std::shared_ptr<const core::VesselTree> tree)
{
    if (tree != tree_) {
        tree_ = std::move(tree);
        emit overlayChanged();
    }
}

void SliceModel::setMarks(const BranchMarks& marks)
{
    if (marks != marks_) {
        marks_ = marks;
        emit overlayChanged();
    }
}

void SliceModel::setPoints(SliceMarkKind kind, std::vector<SliceMark> points)
{
    if (points != points_[kind]) {
        points_[kind] = std::move(points);
        emit overlayChanged();
    }
}

void SliceModel::setMeasurements(std::vector<LabeledMeasurement> measurementData)
{
    if (measurementData != measurements_) {
        measurements_ = std::move(measurementData);
        emit overlayChanged();
    }
}

void SliceModel::setTool(SliceTool* tool)
{
    if (tool == tool_) {
        return;
    }
    if (SliceTool* former = std::exchange(tool_, tool)) {
        former->end();
    }
    emit toolChanged();
}

void SliceModel::setCrosshair(const Eigen::Vector3d& pointInPatient)
{
    const core::VolumeGeometry* where = geometry();
    if (!where) {
        return;
    }
    const Eigen::Vector3d inside = core::clampToVolume(*where, pointInPatient);
    if (inside != crosshair_) {
        crosshair_ = inside;
        emit crosshairChanged();
    }
}

void SliceModel::setWindow(const GrayWindow& window)
{
    const GrayWindow valid{std::max(window.width, 1.0), window.level};
    if (valid != window_) {
        window_ = valid;
        emit appearanceChanged();
    }
}

void SliceModel::setPreviewFrom(std::optional<double> threshold)
{
    if (threshold != previewFrom_) {
        previewFrom_ = threshold;
        emit appearanceChanged();
    }
}

const core::VolumeGeometry* SliceModel::geometry() const
{
    return volume_ ? &volume_->geometry : lumen_ ? &lumen_->geometry : nullptr;
}

}   // namespace angiopose::ui
