#pragma once

#include "core/geometry/pose_axis.h"

#include <string>

namespace angiopose::core {

/// Weighting of the DynaWeightPnP prior against the data (ALGORITHMS §2, decision 17).
enum class PriorPreset { SeedSum, SeedMean, SeedMetric, NoPrior };

/// Tree points of the auxiliary problem in the alternating search (ALGORITHMS §3.2): the branches the user chose, or
/// the nodes if none is chosen; the nodes; the widest branches, up to a third of the length; random points.
enum class AuxiliarySet { Chosen, Nodes, MainBranches, Random };

/// Nearest-point search: exact by k-d tree (the reproduction mode), exact by buckets, or by a lookup table that is
/// accurate to the size of its cells.
enum class IndexKind { KdTree, Grid, Map };

/// Initial ℓ: the largest distance d (at most half the image diagonal) or, as printed in the paper, d² (ALGORITHMS §2,
/// decision 14).
enum class StartScale { Largest, LargestSquared };

/// Criterion for shrinking the kernel width ℓ (ALGORITHMS §3.1).
enum class Decay {
    Halving,   ///< halves ℓ every five accepted steps, as in DynaWeightPnP
    Stagnation   ///< ×0.7 after at least ten steps, as soon as no further points come within range: RKHS-BA
};

/// Target points that attract a tree point (Δ of DynaWeightPnP, ALGORITHMS §2, decision 18).
enum class Neighbors {
    Closest,
    Five,   ///< the five nearest
    Radius   ///< all within three kernel widths, limited to the nearest 64
};

/// Options of dynaweight and iterative-pnp, partly shared by other point-based methods.
struct SeedOptions {
    PriorPreset preset = PriorPreset::SeedMean;
    double priorWeight = 100.0;   ///< weight λ of the prior at the initial pose
    bool rotationFirst = true;   ///< whether to start with a rotation-only solve
    bool alternation = true;   ///< whether to alternate between auxiliary and full problem
    IndexKind index = IndexKind::KdTree;
    StartScale startScale = StartScale::LargestSquared;
    Decay decay = Decay::Halving;
    Neighbors neighbors = Neighbors::Closest;   ///< target points that attract each tree point
    AuxiliarySet auxiliary = AuxiliarySet::Chosen;
    int auxiliaryCount = 60;   ///< number of points in AuxiliarySet::Random

    bool operator==(const SeedOptions&) const = default;
};

/// Minimization by damped steps with updated matches, or by L-BFGS on the squared distances.
enum class DescentSolver { DampedSteps, Lbfgs };

/// Motion model; Affine adds an affine stage, whose rigid part is kept if it fits better.
enum class IcpModel { Rigid, Affine };

/// Options of dt-icp and assembled-icp.
struct IcpOptions {
    int iterations = 100;
    bool alternate = false;   ///< whether to run inside the alternating search
    double huberPx = 5.0;   ///< distance beyond which the force on a point no longer increases
    DescentSolver solver = DescentSolver::DampedSteps;
    IcpModel model = IcpModel::Rigid;

    bool operator==(const IcpOptions&) const = default;
};

/// Image features that attract the tree.
enum class NicpImage { TracedVessels, Brightness };

/// Conversion of a gradient to a step: rotations scaled by the depth, which gives rotations and shifts the same effect
/// in the image, or raw radians next to millimeters, where rotations dominate (ALGORITHMS §3.3).
enum class StepMetric { Balanced, Literal };

/// Options of nicp and nicp-alternating.
struct NicpOptions {
    NicpImage image = NicpImage::TracedVessels;
    StepMetric step = StepMetric::Balanced;
    bool prior = false;   ///< whether to use the prior of SeedOptions
    double startScalePx = 20.0;
    double finalScalePx = 3.0;
    int iterations = 300;   ///< maximum number per scale

    bool operator==(const NicpOptions&) const = default;
};

struct RgbrOptions {
    double reachMm = 20.0;   ///< initial search range along the wall normals
    int hypotheses = 500;
    int rounds = 30;

    bool operator==(const RgbrOptions&) const = default;
};

struct AutoMaskOptions {
    double sample = 100.0;   ///< percentage of the mask's pixels that are sampled
    double marginPx = 8.0;
    int evaluations = 1000;

    bool operator==(const AutoMaskOptions&) const = default;
};

/// Options of gradient-matching.
struct GradientOptions {
    double scalePx = 1.5;
    int powellRounds = 20;

    bool operator==(const GradientOptions&) const = default;
};

struct OgmmOptions {
    double startScalePx = 15.0;
    double finalScalePx = 0.5;
    double orientation = 0.3;   ///< kernel width of the unit directions
    double selfWeight = 1.0;   ///< weight of the term that keeps the projected tree from collapsing

    bool operator==(const OgmmOptions&) const = default;
};

struct CvoOptions {
    double startScalePx = 20.0;
    double finalScalePx = 1.0;
    double decay = 0.95;   ///< factor on ℓ after each step beyond the first thirty
    int iterations = 300;
    bool directions = true;   ///< whether to weight pairs by the similarity of their directions

    bool operator==(const CvoOptions&) const = default;
};

/// Options of matched-branches.
struct BranchOptions {
    double reachPx = 40.0;   ///< 1-σ of the initial misalignment in the image
    int rounds = 50;
    bool motion = true;   ///< whether to deform the vessels onto the curves afterwards and report the motion

    bool operator==(const BranchOptions&) const = default;
};

/// Options of graph-matching.
struct GraphOptions {
    int hypotheses = 300;
    double reachPx = 150.0;   ///< largest distance between matching nodes of tree and image
    double spreadWeight = 0.1;   ///< weight of the term that keeps the projected tree from collapsing

    bool operator==(const GraphOptions&) const = default;
};

enum class EvolutionStrategy { CovarianceMatrix, OnePlusOne };

struct EvolutionOptions {
    EvolutionStrategy strategy = EvolutionStrategy::CovarianceMatrix;
    int population = 16;
    int evaluations = 3000;

    bool operator==(const EvolutionOptions&) const = default;
};

/// Search by an annealed particle filter, or by a sweep of the out-of-plane angles (Tian).
enum class ParticleSearchKind { Filter, OutOfPlane };

struct ParticleOptions {
    ParticleSearchKind search = ParticleSearchKind::Filter;
    int count = 500;
    int rounds = 8;

    bool operator==(const ParticleOptions&) const = default;
};

/// Options of angiopose. The 1-σ errors of the initial pose enter the covariance of every method except wire.
struct AngioPoseOptions {
    bool search = true;   ///< whether to search coarsely before refinement; otherwise only the initial pose is refined
    double searchRadiusMm =
        130.0;   ///< lateral range of the coarse search; only needed if the initial pose does not fit
    double searchTiltDeg = 90.0;   ///< search range in LAO/RAO and CRA/CAU
    double searchRollDeg = 180.0;   ///< search range in roll
    double priorRotationDeg = 8.0;   ///< 1-σ of the initial rotation
    double priorLateralMm = 30.0;   ///< 1-σ of the initial position across the ray
    double priorDepthMm = 30.0;   ///< 1-σ of the initial position along the ray
    double auxiliaryWeight =
        10.0;   ///< weight of the auxiliary branches relative to the fit of all branches; 1 disables the separate fit

    bool operator==(const AngioPoseOptions&) const = default;
};

/// Options of wire: errors of the previous registered pose, and distance of the wire from the vessel centerline.
struct WireOptions {
    double rotationDeg = 2.0;   ///< 1-σ of the initial rotation
    double lateralMm = 5.0;   ///< 1-σ of the initial position across the ray
    double depthMm = 10.0;   ///< 1-σ of the initial position along the ray
    double offAxisMm =
        1.5;   ///< 1-σ distance of the wire from the centerline, in addition to its freedom inside the lumen
    int way = 1;   ///< rank of the path to use, counting from the most likely; overrides the automatic choice

    bool operator==(const WireOptions&) const = default;
};

/// Errors of focal length and principal point: by origin of the values (ALGORITHMS §5.8), as given here, or none.
enum class GeometrySpread { ByOrigin, Given, None };

/// Camera errors that enter the covariance of every method, and the reaction to a camera that the images contradict.
struct GeometryOptions {
    GeometrySpread spread = GeometrySpread::ByOrigin;
    double focalPercent = 3.0;   ///< 1-σ, for GeometrySpread::Given
    double principalPx = 10.0;   ///< 1-σ of each coordinate, for GeometrySpread::Given
    bool estimate = false;   ///< whether to register again with the estimated camera if images contradict the camera
    bool checkOrientation =
        true;   ///< whether angiopose tests, after a failed registration, if the image is mirrored or rotated

    bool operator==(const GeometryOptions&) const = default;
};

/// Whether to deform the vessels onto the image after a rigid registration (ALGORITHMS §11).
enum class Deformation {
    Off,
    Auto,   ///< if a fit of angiopose without locks shows signs of deformation (§11.5)
    Always
};

/// Selected method, common options, and the options of each method. optionFields() describes them for users.
struct RegistrationOptions {
    std::string method = "angiopose";

    double pointSpacingMm = 1.0;   ///< spacing of the tree points
    double targetSpacingPx = 1.0;   ///< spacing of the target points
    bool resample = true;   ///< whether to resample to the spacings above or to use the original points
    int maxIterations = 60;
    double finalScalePx = 1.0;   ///< kernel width at which the annealing ends
    int randomSeed = 1;   ///< seed of the methods that use random numbers

    Deformation deformation = Deformation::Auto;

    GeometryOptions geometry{};
    AngioPoseOptions angiopose{};
    SeedOptions seed{};
    IcpOptions icp{};
    NicpOptions nicp{};
    RgbrOptions rgbr{};
    AutoMaskOptions automask{};
    GradientOptions gradient{};
    OgmmOptions ogmm{};
    CvoOptions cvo{};
    BranchOptions branches{};
    GraphOptions graph{};
    EvolutionOptions evolution{};
    ParticleOptions particle{};
    WireOptions wire{};

    PoseLocks locks{};   ///< degrees of freedom kept at their initial values; nearly all methods support them

    bool operator==(const RegistrationOptions&) const = default;
};

}   // namespace angiopose::core
