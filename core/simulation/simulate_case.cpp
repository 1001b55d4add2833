#include "core/simulation/simulated_case.h"

#include "core/messages/messages.h"
#include "core/simulation/deform_tree.h"
#include "core/simulation/fit_pose_to_correspondences.h"
#include "core/simulation/form_dsa_frames.h"
#include "core/simulation/opacify_vessels.h"
#include "core/simulation/simulate_view_of.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace angiopose::core {
namespace {

/// Random streams of a case, one per part; random draws for one part never affect another part.
enum CaseStream : std::uint64_t { GeometryStream = 1, DeformationStream, FillingStream, ImageStream };

constexpr double angleErrorDeg = 1.0;
constexpr double lateralErrorMm = 15.0;
constexpr double depthErrorMm = 30.0;
constexpr double centeringErrorMm = 8.0;   ///< accuracy with which operators center the vessels

template <class T>
SourcedValue<T> fromHeader(T value, const char* tag)
{
    return {value, Origin::Header, tag};
}

double roundedTo(double value, double step)
{
    return std::round(value / step) * step;
}

/// Draws a clinical geometry whose field of view contains the vessels; values are rounded as in DICOM headers.
CArm drawCArm(double extentMm, const DsaOptions& dsa, CounterRandom& random)
{
    CArm cArm;
    const double sidMm = roundedTo(random.uniform(1000.0, 1200.0), 1.0);
    const double sodMm = roundedTo(random.uniform(700.0, 820.0), 1.0);
    const double fieldMm = random.uniform(1.1, 1.25) * extentMm * sidMm / sodMm;
    const double spacingMm = roundedTo(fieldMm / std::min(dsa.width, dsa.height), 0.001);
    cArm.sourceToDetectorMm = fromHeader(sidMm, "(0018,1110)");
    cArm.sourceToIsocenterMm = fromHeader(sodMm, "(0018,9402)");
    cArm.columnSpacingMm = fromHeader(spacingMm, "(0018,1164)");
    cArm.rowSpacingMm = fromHeader(spacingMm, "(0018,1164)");
    cArm.primaryAngleDeg = fromHeader(roundedTo(random.uniform(-45.0, 45.0), 0.1), "(0018,1510)");
    cArm.secondaryAngleDeg = fromHeader(roundedTo(random.uniform(-30.0, 30.0), 0.1), "(0018,1511)");
    return cArm;
}

/// Returns the true gantry angles: the header's angles are off by about a degree, and the detector is slightly rotated.
CArm withTrueAngles(CArm cArm, CounterRandom& random)
{
    *cArm.primaryAngleDeg.value += angleErrorDeg * random.normal();
    *cArm.secondaryAngleDeg.value += angleErrorDeg * random.normal();
    cArm.rollDeg = {angleErrorDeg * random.normal(), Origin::Assumed, ""};
    return cArm;
}

/// Draws an offset in the patient frame with the given standard deviations perpendicular to and along the ray.
Eigen::Vector3d drawOffset(const CArm& cArm, double lateralStdMm, double depthStdMm, CounterRandom& random)
{
    const double x = lateralStdMm * random.normal();
    const double y = lateralStdMm * random.normal();
    const double z = depthStdMm * random.normal();
    const Result<RigidTransform> pose = cameraFromPatient(cArm, Eigen::Vector3d::Zero());
    assert(pose);
    return pose.value().rotation.transpose() * Eigen::Vector3d(x, y, z);
}

TrueViewGeometry drawGeometry(const Eigen::Vector3d& centroid, double extentMm, const DsaOptions& dsa,
                              CounterRandom random)
{
    TrueViewGeometry geometry;
    geometry.header = drawCArm(extentMm, dsa, random);
    const CArm truth = withTrueAngles(geometry.header, random);
    const Eigen::Vector3d isocenter = centroid + drawOffset(truth, centeringErrorMm, 0.5 * depthErrorMm, random);
    const Eigen::Vector3d guess = isocenter + drawOffset(geometry.header, lateralErrorMm, depthErrorMm, random);
    const Result<ProjectionCamera> camera = cameraFromCArm(geometry.header, dsa.width, dsa.height);
    const Result<RigidTransform> truePose = cameraFromPatient(truth, isocenter);
    const Result<RigidTransform> initialPose = cameraFromPatient(geometry.header, guess);
    assert(camera && truePose && initialPose);   // drawCArm sets every value
    geometry.camera = camera.value();
    geometry.trueCameraFromPatient = truePose.value();
    geometry.initialCameraFromPatient = initialPose.value();
    return geometry;
}

/// Returns the rigid pose whose projection of the undeformed tree is closest to that of the deformed tree.
RigidTransform bestRigidPose(const VesselTree& tree, const VesselTree& warped, const ProjectionCamera& camera,
                             const RigidTransform& cameraFromPatient)
{
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector2d> pixels;
    for (std::size_t b = 0; b < tree.branches.size(); ++b) {
        for (std::size_t i = 0; i < tree.branches[b].pointsInPatient.size(); ++i) {
            const auto pixel = project(camera, cameraFromPatient * warped.branches[b].pointsInPatient[i]);
            if (pixel) {
                points.push_back(tree.branches[b].pointsInPatient[i]);
                pixels.push_back(*pixel);
            }
        }
    }
    return fitPoseToCorrespondences(points, pixels, camera, cameraFromPatient);
}

VesselTree transformedTree(VesselTree tree, const RigidTransform& motion)
{
    for (VesselBranch& branch : tree.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            point = motion * point;
        }
    }
    return tree;
}

Angiogram asAngiogram(DsaRun run, const CArm& header, std::uint64_t seed)
{
    Angiogram angiogram;
    angiogram.frames = std::move(run.frames);
    angiogram.polarity = Polarity::VesselsDark;
    angiogram.frameTimeMs = run.frameTimeMs;
    angiogram.suggestedFrame = run.peakFrame;
    angiogram.cArm = header;
    angiogram.identity.patientName = "Simulated";
    angiogram.identity.patientId = "SIM-" + std::to_string(seed);
    angiogram.identity.modality = "XA";
    angiogram.identity.manufacturer = "AngioPose simulator";
    angiogram.identity.description = "Simulated DSA, seed " + std::to_string(seed);
    return angiogram;
}

}   // namespace

std::optional<Message> findProblem(const TreeOptions& tree, const DsaOptions& dsa)
{
    const struct {
        const char* name;
        double value, min, max;
    } limits[] = {{"branchCount", static_cast<double>(tree.branchCount), 1.0, 200.0},
                  {"nonRigidStdMm", dsa.nonRigidStdMm, 0.0, 50.0},
                  {"missingBranchShare", dsa.missingBranchShare, 0.0, 1.0},
                  {"extraBranchShare", dsa.extraBranchShare, 0.0, 1.0},
                  {"frameCount", static_cast<double>(dsa.frameCount), 1.0, 1000.0}};
    for (const auto& [name, value, min, max] : limits) {
        if (!(value >= min && value <= max)) {
            const auto number = [](double given) { return Quantity{given, Quantity::significantDigits}; };
            return messages::simulationOutOfRange(name, number(min), number(max), number(value));
        }
    }
    return {};
}

SimulatedCase simulateCase(std::uint64_t seed, const TreeOptions& tree, const DsaOptions& dsa)
{
    return simulateView(seed, seed, tree, dsa);
}

SimulatedCase simulateView(std::uint64_t treeSeed, std::uint64_t viewSeed, const TreeOptions& tree,
                           const DsaOptions& dsa)
{
    return simulateViewOf(growTree(treeSeed, tree), tree.extentMm, viewSeed, dsa);
}

SimulatedCase simulateViewOf(const GrownTree& grown, double extentMm, std::uint64_t viewSeed, const DsaOptions& dsa)
{
    const TrueViewGeometry geometry =
        drawGeometry(centroidInPatient(grown.tree), extentMm, dsa, CounterRandom(viewSeed).fork(GeometryStream));
    return simulateViewOf(grown, geometry, viewSeed, dsa);
}

SimulatedCase simulateViewOf(const GrownTree& grown, const TrueViewGeometry& geometry, std::uint64_t viewSeed,
                             const DsaOptions& dsa)
{
    const CounterRandom random(viewSeed);
    GrownTree warped = grown;
    CounterRandom deformation = random.fork(DeformationStream);
    if (dsa.nonRigidStdMm > 0.0) {
        warped.tree = deformed(grown.tree, dsa.nonRigidStdMm, deformation);
    }
    CounterRandom filling = random.fork(FillingStream);
    OpacifiedVessels vessels = opacifyVessels(warped, dsa, filling);

    SimulatedCase result;
    result.tree = grown.tree;
    result.camera = geometry.camera;
    result.initialCameraFromPatient = geometry.initialCameraFromPatient;
    result.trueCameraFromPatient = geometry.trueCameraFromPatient;
    if (dsa.nonRigidStdMm > 0.0) {
        result.trueCameraFromPatient =
            bestRigidPose(grown.tree, warped.tree, geometry.camera, geometry.trueCameraFromPatient);
        result.deformedTree =
            transformedTree(warped.tree, result.trueCameraFromPatient.inverse() * geometry.trueCameraFromPatient);
    }
    result.missingBranchIds = vessels.missingBranchIds;
    result.trueTarget = projectCurves(vessels.visible, geometry.camera, geometry.trueCameraFromPatient);
    result.trueCatheter = projectCurves(vessels.catheter, geometry.camera, geometry.trueCameraFromPatient);
    const DsaScene scene{std::move(vessels.paths), vessels.maxPathMm, geometry.camera, geometry.trueCameraFromPatient};
    DsaRun run = formDsaFrames(scene, dsa, random.fork(ImageStream));
    result.trueContrast = std::move(run.trueContrast);
    result.angiogram = asAngiogram(std::move(run), geometry.header, viewSeed);
    return result;
}

}   // namespace angiopose::core
