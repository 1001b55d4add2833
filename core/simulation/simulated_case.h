#pragma once

#include "core/geometry/c_arm.h"
#include "core/imaging/angiogram.h"
#include "core/support/message.h"
#include "core/support/random.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_tree.h"

#include <cstdint>
#include <optional>

namespace angiopose::core {

/// Options of a generated tree; lengths in mm.
struct TreeOptions {
    int branchCount = 24;
    double extentMm = 180.0;   ///< approximate size of the bounding box
    double rootRadiusMm = 3.0;
    double pointSpacingMm = 1.0;
};

/// Generates a random, smooth, bifurcating vessel tree around the origin of the patient frame, determined by the seed.
VesselTree simulateTree(std::uint64_t seed, const TreeOptions& options = {});

/// Timing of the contrast bolus, in seconds; points in time are relative to the start of the injection.
struct ContrastTiming {
    double firstS = 0.0;   ///< start of the run
    double runS = 3.6;   ///< duration of the run, from inflow to washout of the bolus
    double fillingS = 1.4;   ///< transit time from the inlet to the farthest tip
    double injectionS = 1.6;
    double riseS = 0.4;   ///< temporal blur of the bolus front
    double washoutS = 0.45;   ///< decay time after the injection
};

/// Image formation options (ALGORITHMS §4.4).
struct DsaOptions {
    int width = 512;
    int height = 512;
    int frameCount = 8;   ///< number of frames of the bolus passage; opacification peaks in the middle
    double photonCount = 3000.0;   ///< expected photons per pixel behind the average patient (N0 of the Poisson noise)
    double missingBranchShare = 0.2;   ///< fraction of the branches; they drop out from the ends, thin ones more often
    double extraBranchShare = 0.1;   ///< probability per branch of an additional vessel that is not in the tree
    double nonRigidStdMm = 0.0;   ///< standard deviation per axis of a smooth deformation of the true vessels
    double catheterProbability = 0.5;
    double maskMotionPx = 1.0;   ///< maximum shift between mask and contrast frames
    double shutterProbability = 0.5;   ///< probability of a black octagonal or round border, like a display shutter
    ContrastTiming timing{};
};

/// Returns a message about options that cannot be simulated; nullopt if all options are valid.
std::optional<Message> findProblem(const TreeOptions& tree, const DsaOptions& dsa);

/// A simulated case with known ground truth.
struct SimulatedCase {
    VesselTree tree;
    Angiogram angiogram;   ///< DSA run with dark vessels; its geometry is that of the header
    ProjectionCamera camera;
    RigidTransform trueCameraFromPatient;   ///< true pose; for deformed vessels, the best-fitting rigid pose
    std::optional<VesselTree> deformedTree;   ///< deformed vessels, at their true positions under trueCameraFromPatient
    RigidTransform initialCameraFromPatient;   ///< as in DICOM: angles ±1°, isocenter error 15 mm lateral, 30 mm depth
    std::vector<int> missingBranchIds;   ///< branches that are unopacified in the image
    Centerline2d trueTarget;   ///< opacified branches and extra vessels, projected by projectCurves
    Centerline2d trueCatheter;   ///< one curve, or none if there is no catheter
    ImageF trueContrast;   ///< noise-free decrease of the gray values in the suggested frame due to the contrast agent
};

/// Simulates a tree, a clinical C-arm pose and DSA frames, all determined by the seed.
SimulatedCase simulateCase(std::uint64_t seed, const TreeOptions& tree = {}, const DsaOptions& dsa = {});

/// Simulates a view of the tree with seed `treeSeed`; `viewSeed` determines pose, opacification and image.
SimulatedCase simulateView(std::uint64_t treeSeed, std::uint64_t viewSeed, const TreeOptions& tree = {},
                           const DsaOptions& dsa = {});

/// Perturb a pose by one of the conventions of ALGORITHMS §4.2, which are never mixed in one table. OBJ: rotation about
/// the tree's centroid, then shift. CAM: twist applied in the camera frame (rotation about the source).
RigidTransform perturbAboutCentroid(const RigidTransform& cameraFromPatient, const Eigen::Vector3d& centroidInPatient,
                                    double rotationStdDeg, double translationStdMm, CounterRandom& random);
RigidTransform perturbAboutSource(const RigidTransform& cameraFromPatient, double rotationStdDeg,
                                  double translationStdMm, CounterRandom& random);

/// Perturbs a pose as OBJ with uniformly distributed components: rotation by up to ±`rangeDeg` about each camera axis
/// and shift by up to ±`rangeMm` along each.
RigidTransform displaceUniformly(const RigidTransform& cameraFromPatient, const Eigen::Vector3d& centroidInPatient,
                                 double rangeDeg, double rangeMm, CounterRandom& random);

/// Returns the exact projections of all tree points, one curve per branch; points behind the source are left out.
Centerline2d projectTree(const VesselTree& tree, const ProjectionCamera& camera,
                         const RigidTransform& cameraFromPatient);

/// Returns the projected curves as traced in an ideal image, resampled at 1 px. Except at the ends, no point is the
/// projection of a tree point, so there are no exact correspondences.
Centerline2d projectCurves(const VesselTree& tree, const ProjectionCamera& camera,
                           const RigidTransform& cameraFromPatient);

}   // namespace angiopose::core
