#include "io/opening/assemble_case.h"

#include "io/support/input_bytes.h"

#include <algorithm>
#include <filesystem>

namespace angiopose::io {
namespace {

/// Returns the file name without extension: "chest" for "chest.nii.gz".
std::string baseName(const std::string& path)
{
    const std::string name = std::filesystem::path(path).filename().string();
    return name.substr(0, name.size() - std::min(name.size(), extensionOf(path).size()));
}

/// Keeps the scan of the case if the new vessels come from another file but lie within the scan.
void updateScan(core::Vessels& vessels, const LoadedInputs& inputs)
{
    if (!inputs.volume && vessels.scan && isInsideScan(vessels.scan->geometry, *inputs.tree)) {
        if (vessels.input.kind == core::VesselInputKind::Volume) {
            vessels.scanFile = vessels.file;
            vessels.scanSeriesId = vessels.input.seriesId;
        }
        return;
    }
    vessels.scan = inputs.volume;
    vessels.measurements.clear();   // slice measurements belong to the previous scan
    vessels.scanIdentity = inputs.scanIdentity;
    vessels.scanFile = {};
    vessels.scanSeriesId.clear();
}

void putTree(core::Vessels& vessels, const LoadedInputs& inputs)
{
    updateScan(vessels, inputs);
    vessels.tree = inputs.tree;
    vessels.file = inputs.centerlineFile;
    vessels.input = inputs.vesselInput;
    vessels.lumen = inputs.lumen;
    vessels.isLumenEdited = false;
    vessels.isTreeEdited = false;
    vessels.hiddenBranchIds.clear();
    vessels.pickedPivotInPatient.reset();
    vessels.auxiliaryBranchIds.clear();
    vessels.excludedBranchIds.clear();
}

void putImage(core::View& view, const LoadedInputs& inputs)
{
    view.angiogram = inputs.angiogram;
    view.imageFile = inputs.imageFile;
    view.frame = inputs.angiogram->suggestedFrame;
    view.geometry = {inputs.angiogram->cArm, std::nullopt};
    view.storedRun = inputs.storedRun;
    view.headerPlan = inputs.headerPlan;
    view.processing = {.isSubtracted = inputs.storedRun != nullptr, .plan = inputs.headerPlan};
    view.target = {};
}

void goToStart(core::Case& target)
{
    if (const auto start = core::initialPoseOf(target)) {
        target.shown().cameraFromPatient = start.value();
    }
}

}   // namespace

bool isInsideScan(const core::VolumeGeometry& scan, const core::VesselTree& tree)
{
    const Eigen::Affine3d voxelFromPatient = scan.patientFromVoxel().inverse();
    std::size_t inside = 0;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            inside += scan.contains((voxelFromPatient * point).array().round().cast<int>()) ? 1 : 0;
        }
    }
    return 2 * inside > tree.pointCount();
}

core::Case assembleCase(core::Case base, const LoadedInputs& inputs)
{
    core::Vessels& vessels = base.vessels;
    core::View& view = base.shown();
    if (inputs.tree) {
        putTree(vessels, inputs);
        vessels.marks.clear();   // marks belong to the previous vessels
        for (core::View& each : base.views) {
            each.observations.clear();
        }
    }
    if (inputs.volume && !inputs.tree) {
        vessels.scan = inputs.volume;
        vessels.measurements.clear();   // slice measurements belong to the previous scan
        vessels.scanIdentity = inputs.scanIdentity;
        vessels.scanFile = inputs.scanFile;
        vessels.scanSeriesId = inputs.scanSeriesId;
    }
    if (inputs.angiogram) {
        putImage(view, inputs);
    }
    if (inputs.target) {
        view.target = {inputs.targetFile, inputs.target, std::nullopt, {}};
    }
    if (inputs.tree || inputs.angiogram) {
        core::discardResults(view);
        view.initialCameraFromPatient.reset();
        view.landmarks.clear();   // landmarks belong to the previous vessels or image
        if (inputs.angiogram) {
            view.measurements.clear();
            view.observations.clear();
            view.annotations.clear();
            view.enteredMmPerPx.reset();
        }
        goToStart(base);
    }
    if (base.title.empty()) {
        const std::string& path = view.angiogram ? view.imageFile.path
                                  : vessels.tree ? vessels.file.path
                                                 : vessels.scanFile.path;
        base.title = baseName(path);
    }
    return base;
}

bool isCompleteCase(const LoadedInputs& inputs)
{
    return inputs.tree && inputs.angiogram;
}

}   // namespace angiopose::io
