#include "app/files/assemble_case.h"

#include <filesystem>

namespace angiopose::app {
namespace {

/// The scan of the case stays beside vessels that come from elsewhere but lie in it.
void putScan(core::RegistrationCase& target, const LoadedInputs& inputs)
{
    if (!inputs.volume && target.volume && liesIn(target.volume->geometry, *inputs.tree)) {
        if (target.vesselInput.kind == core::VesselInputKind::Volume) {
            target.scanFile = target.centerlineFile;
            target.scanSeriesId = target.vesselInput.seriesId;
        }
        return;
    }
    target.volume = inputs.volume;
    target.scanIdentity = inputs.scanIdentity;
    target.scanFile = {};
    target.scanSeriesId.clear();
}

void putTree(core::RegistrationCase& target, const LoadedInputs& inputs)
{
    putScan(target, inputs);
    target.tree = inputs.tree;
    target.centerlineFile = inputs.centerlineFile;
    target.vesselInput = inputs.vesselInput;
    target.lumen = inputs.lumen;
    target.isTreeEdited = false;
    target.hiddenBranchIds.clear();
    target.pickedPivotInPatient.reset();
    target.auxiliaryBranchIds.clear();
    target.excludedBranchIds.clear();
}

void putTarget(core::RegistrationCase& target, const std::shared_ptr<const core::Centerline2d>& given,
               const core::InputFile& file)
{
    target.givenTarget = given;
    target.targetFile = file;
    target.editedFrame.reset();
    target.acceptedCurveIds.clear();
}

void putImage(core::RegistrationCase& target, const LoadedInputs& inputs)
{
    target.angiogram = inputs.angiogram;
    target.imageFile = inputs.imageFile;
    target.frame = inputs.angiogram->suggestedFrame;
    target.cArm = inputs.angiogram->cArm;
    target.cameraOverride.reset();
    target.storedRun.reset();
    target.headerPlan = inputs.headerPlan;
    target.treatment = {.plan = inputs.headerPlan};
    putTarget(target, nullptr, {});
}

void goToStart(core::RegistrationCase& target)
{
    if (const auto start = core::startPoseOf(target)) {
        target.cameraFromPatient = start.value();
    }
}

bool isSamePose(const core::RigidTransform& a, const core::RigidTransform& b)
{
    return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() < 1e-9;
}

}   // namespace

bool liesIn(const core::VolumeGeometry& scan, const core::VesselTree& tree)
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

core::RegistrationCase withInputs(core::RegistrationCase base, const LoadedInputs& inputs)
{
    if (inputs.tree) {
        putTree(base, inputs);
    }
    if (inputs.volume && !inputs.tree) {
        base.volume = inputs.volume;
        base.scanIdentity = inputs.scanIdentity;
        base.scanFile = inputs.scanFile;
        base.scanSeriesId = inputs.scanSeriesId;
    }
    if (inputs.angiogram) {
        putImage(base, inputs);
    }
    if (inputs.target) {
        putTarget(base, inputs.target, inputs.targetFile);
    }
    if (inputs.tree || inputs.angiogram) {
        base.result.reset();
        base.hasInitialPose = false;
        base.landmarks.clear();   // of other vessels, or in another image
        goToStart(base);
    }
    if (base.title.empty()) {
        const std::string& vessels = base.tree ? base.centerlineFile.path : base.scanFile.path;
        const std::string& path = base.angiogram ? base.imageFile.path : vessels;
        base.title = std::filesystem::path(path).stem().string();
    }
    return base;
}

bool makesNewCase(const LoadedInputs& inputs)
{
    return inputs.tree && inputs.angiogram;
}

core::RegistrationCase withGeometry(core::RegistrationCase base, const core::CArm& cArm)
{
    const auto before = core::startPoseOf(base);
    base.cArm = cArm;
    const bool wasAtStart = !before || isSamePose(before.value(), base.cameraFromPatient);
    if (wasAtStart) {
        goToStart(base);
    }
    base.result.reset();
    return base;
}

}   // namespace angiopose::app