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

/// Shape of a generated tree; lengths mm.
struct TreeOptions {
    int branchCount = 24;
    double extentMm = 180.0;   ///< about the size of the bounding box
    double rootRadiusMm = 3.0;
    double pointSpacingMm = 1.0;
};

/// A random, smooth, bifurcating vessel tree around the origin of the patient frame. Same seed, same tree.
VesselTree simulateTree(std::uint64_t seed, const TreeOptions& options = {});

/// When the contrast medium comes and goes, in seconds since the injection began.
struct ContrastTiming {
    double firstS = 0.0;   ///< where the run begins
    double runS = 3.6;   ///< how long it lasts: the bolus comes and goes
    double fillingS = 1.4;   ///< inlet to the farthest tip
    double injectionS = 1.6;
    double riseS = 0.4;   ///< the front is this blurred
    double washoutS = 0.45;   ///< decay time after the injection
};

/// Image formation (ALGORITHMS §4.4).
struct DsaOptions {
    int width = 512;
    int height = 512;
    int frameCount = 8;   ///< bolus passes through; the middle frames are the fullest
    double photonCount = 3000.0;   ///< N0 of the Poisson noise
    double missingBranchShare = 0.2;   ///< of the branches; they close from the ends, thin ones more often
    double extraBranchShare = 0.1;   ///< 2-D vessels that the tree does not have, per branch
    double nonRigidStdMm = 0.0;   ///< smooth deformation of the true vessel
    double catheterProbability = 0.5;
    double maskMotionPx = 1.0;   ///< up to this shift between mask and contrast frames
    double shutterProbability = 0.5;   ///< black, octagonal or round border, as exported with the display shutter
    ContrastTiming timing{};
};

/// What cannot be simulated, in words for the user; empty when all can.
std::optional<Message> findProblem(const TreeOptions& tree, const DsaOptions& dsa);

/// A case with known answer.
struct SimulatedCase {
    VesselTree tree;
    Angiogram angiogram;   ///< DSA run, vessels dark, geometry as a header would give it
    ProjectionCamera camera;
    RigidTransform trueCameraFromPatient;   ///< best rigid pose
    std::optional<VesselTree> deformedTree;   ///< of deformed vessels: as they lay, seen with trueCameraFromPatient
    RigidTransform initialCameraFromPatient;   ///< DICOM-like: angles ±1°, isocentre off by lateral 15 mm, depth 30 mm
    std::vector<int> missingBranchIds;   ///< not filled in the image
    Centerline2d trueTarget;   ///< the filled branches and the extra vessels, as projectCurves shows them
    Centerline2d trueCatheter;   ///< one curve, or none without a catheter
    ImageF trueContrast;   ///< of the suggested frame: grey values by which contrast medium darkens it, without noise
};

/// Tree, clinical C-arm pose, DSA frames. Everything follows from the seed.
SimulatedCase simulateCase(std::uint64_t seed, const TreeOptions& tree = {}, const DsaOptions& dsa = {});

/// Another view of the tree of `treeSeed`: pose, filling and image follow from `viewSeed`.
SimulatedCase simulateView(std::uint64_t treeSeed, std::uint64_t viewSeed, const TreeOptions& tree = {},
                           const DsaOptions& dsa = {});

/// Pose noise conventions of ALGORITHMS §4.2, never mixed in one table.
/// OBJ: rotation about the tree's centroid, then shift. CAM: twist applied in the camera frame (rotates about the
/// source).
RigidTransform perturbedAboutCentroid(const RigidTransform& cameraFromPatient, const Eigen::Vector3d& centroidInPatient,
                                      double rotationStdDeg, double translationStdMm, CounterRandom& random);
RigidTransform perturbedAboutSource(const RigidTransform& cameraFromPatient, double rotationStdDeg,
                                    double translationStdMm, CounterRandom& random);

/// OBJ too, but every part uniform: turned by up to ±`rangeDeg` about each camera axis, shifted by up to ±`rangeMm`
/// along each.
RigidTransform uniformlyDisplaced(const RigidTransform& cameraFromPatient, const Eigen::Vector3d& centroidInPatient,
                                  double rangeDeg, double rangeMm, CounterRandom& random);

/// Exact projections of every tree point, one curve per branch (points behind the source are left out).
Centerline2d projectTree(const VesselTree& tree, const ProjectionCamera& camera,
                         const RigidTransform& cameraFromPatient);

/// The same curves as an ideal image shows them, sampled anew every px: but for the ends no point is the projection of
/// a tree point, so that nothing has an exact partner.
Centerline2d projectCurves(const VesselTree& tree, const ProjectionCamera& camera,
                           const RigidTransform& cameraFromPatient);

}   // namespace angiopose::core