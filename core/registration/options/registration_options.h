#pragma once

#include "core/geometry/pose_axis.h"

#include <string>

namespace angiopose::core {

/// How the prior of the seed is weighed against the data (ALGORITHMS §2, decision 17).
enum class PriorPreset { SeedSum, SeedMean, SeedMetric, NoPrior };

/// Which tree points the alternating search solves by themselves (ALGORITHMS §3.2): the branches the user chose, or the
/// nodes where none is chosen; the nodes; the widest branches, up to a third of the length; random points.
enum class AuxiliarySet { Chosen, Nodes, MainBranches, Random };

/// How nearest points are found: exactly by tree (the reproduction mode) or by buckets, or from a table that is right
/// to within its cells.
enum class IndexKind { KdTree, Grid, Map };

/// Where ℓ starts: at the largest distance d (at most half the image diagonal), or, as the paper prints it, at d²
/// (ALGORITHMS §2, decision 14).
enum class StartScale { Largest, LargestSquared };

/// When the kernel width ℓ shrinks (ALGORITHMS §3.1).
enum class Decay {
    Halving,   ///< ÷2 every five accepted steps: the seed
    Stagnation   ///< ×0.7 after at least ten steps, once no further point comes within reach: RKHS-BA
};

/// Which target points pull a tree point (Δ of the seed, ALGORITHMS §2, decision 18).
enum class Neighbors {
    Closest,
    Five,   ///< the five nearest
    Radius   ///< all within three kernel widths, the nearest 64 at most
};

/// What dynaweight and iterative-pnp go by; other methods on points read what they share with them.
struct SeedOptions {
    PriorPreset preset = PriorPreset::SeedMean;
    double priorWeight = 100.0;   ///< λ of the pull towards the start pose
    bool rotationFirst = true;   ///< a rotation-only solve comes first
    bool alternation = true;   ///< auxiliary and full problem take turns
    IndexKind index = IndexKind::KdTree;
    StartScale startScale = StartScale::LargestSquared;
    Decay decay = Decay::Halving;
    Neighbors neighbors = Neighbors::Closest;   ///< how many target points pull each tree point
    AuxiliarySet auxiliary = AuxiliarySet::Chosen;
    int auxiliaryCount = 60;   ///< points of AuxiliarySet::Random

    bool operator==(const SeedOptions&) const = default;
};

/// Damped steps with fresh matches, or L-BFGS on the squared distances.
enum class DescentSolver { DampedSteps, Lbfgs };

/// Affine: an affine stage follows, its rigid part is kept if it fits better.
enum class IcpModel { Rigid, Affine };

/// dt-icp, assembled-icp.
struct IcpOptions {
    int iterations = 100;
    bool alternate = false;   ///< inside the alternating search
    double huberPx = 5.0;   ///< distance from which pulls stop growing
    DescentSolver solver = DescentSolver::DampedSteps;
    IcpModel model = IcpModel::Rigid;

    bool operator==(const IcpOptions&) const = default;
};

/// What attracts the tree.
enum class NicpImage { TracedVessels, Brightness };

/// How the gradient becomes a step: rotations scaled by the depth, so that both move the image alike, or raw radians
/// beside millimetres, where rotation takes it all (ALGORITHMS §3.3).
enum class StepMetric { Balanced, Literal };

/// nicp, nicp-alternating.
struct NicpOptions {
    NicpImage image = NicpImage::TracedVessels;
    StepMetric step = StepMetric::Balanced;
    bool prior = false;   ///< with the prior of SeedOptions
    double startScalePx = 20.0;
    double finalScalePx = 3.0;
    int iterations = 300;   ///< per scale

    bool operator==(const NicpOptions&) const = default;
};

struct RgbrOptions {
    double reachMm = 20.0;   ///< first search along the normals
    int hypotheses = 500;
    int rounds = 30;

    bool operator==(const RgbrOptions&) const = default;
};

struct AutoMaskOptions {
    double sample = 100.0;   ///< % of the mask
    double marginPx = 8.0;
    int evaluations = 1000;

    bool operator==(const AutoMaskOptions&) const = default;
};

/// gradient-matching.
struct GradientOptions {
    double scalePx = 1.5;
    int powellRounds = 20;

    bool operator==(const GradientOptions&) const = default;
};

struct OgmmOptions {
    double startScalePx = 15.0;
    double finalScalePx = 0.5;
    double orientation = 0.3;   ///< kernel width of the directions
    double selfWeight = 1.0;   ///< of the term that keeps the projected tree from collapsing

    bool operator==(const OgmmOptions&) const = default;
};

struct CvoOptions {
    double startScalePx = 20.0;
    double finalScalePx = 1.0;
    double decay = 0.95;   ///< of the width with each step after the first thirty
    int iterations = 300;
    bool directions = true;   ///< pairs count by how alike they run

    bool operator==(const CvoOptions&) const = default;
};

/// matched-branches.
struct BranchOptions {
    double reachPx = 40.0;   ///< 1-σ of how far the image may be off at first
    int rounds = 50;
    bool motion = true;   ///< afterwards the vessels are moved onto their partners, and how far is told

    bool operator==(const BranchOptions&) const = default;
};

/// graph-matching.
struct GraphOptions {
    int hypotheses = 300;
    double reachPx = 150.0;   ///< between a node of the tree and one of the image that may be the same
    double spreadWeight = 0.1;   ///< of the term that keeps the projected tree from collapsing

    bool operator==(const GraphOptions&) const = default;
};

enum class EvolutionStrategy { CovarianceMatrix, OnePlusOne };

struct EvolutionOptions {
    EvolutionStrategy strategy = EvolutionStrategy::CovarianceMatrix;
    int population = 16;
    int evaluations = 3000;

    bool operator==(const EvolutionOptions&) const = default;
};

/// An annealed particle filter, or a walk over the out-of-plane angles (Tian).
enum class ParticleSearchKind { Filter, OutOfPlane };

struct ParticleOptions {
    ParticleSearchKind search = ParticleSearchKind::Filter;
    int count = 500;
    int rounds = 8;

    bool operator==(const ParticleOptions&) const = default;
};

/// angiopose. The errors of the start pose hold for the covariance of every method but wire.
struct AngioPoseOptions {
    bool search = true;   ///< coarse search before refining; else the start pose only
    double searchRadiusMm = 130.0;   ///< lateral reach of the coarse search; only starts that do not fit need it
    double searchTiltDeg = 90.0;   ///< reach of the search in LAO/RAO and CRA/CAU
    double searchRollDeg = 180.0;   ///< reach of the search in roll
    double priorRotationDeg = 8.0;   ///< 1-σ of the start pose's rotation
    double priorLateralMm = 30.0;   ///< 1-σ of the start pose across the ray
    double priorDepthMm = 30.0;   ///< 1-σ of the start pose along the ray
    double auxiliaryWeight = 10.0;   ///< of chosen auxiliary branches against the fit of all; 1: no fit apart

    bool operator==(const AngioPoseOptions&) const = default;
};

/// wire. How far the last full pose may be off, and the wire from the axis.
struct WireOptions {
    double rotationDeg = 2.0;   ///< 1-σ of the start pose's rotation
    double lateralMm = 5.0;   ///< 1-σ of the start pose across the ray
    double depthMm = 10.0;   ///< 1-σ of the start pose along the ray
    double offAxisMm = 1.5;   ///< 1-σ of the wire from the vessel's axis, beside what the lumen lets it
    int way = 1;   ///< that is taken, 1 the most likely: for whoever knows better

    bool operator==(const WireOptions&) const = default;
};

/// How far focal length and principal point may be off: by where they come from (ALGORITHMS §5.8), as given here, or
/// not at all.
enum class GeometrySpread { ByOrigin, Given, None };

/// What the covariance of every method reads, and what becomes of a camera that images contradict.
struct GeometryOptions {
    GeometrySpread spread = GeometrySpread::ByOrigin;
    double focalPercent = 3.0;   ///< 1-σ, where it is given
    double principalPx = 10.0;   ///< 1-σ of each coordinate, where it is given
    bool estimate = false;   ///< where images contradict the camera: register again with the one that they show
    bool otherFrames = true;   ///< where a run fails, is the image mirrored or turned? angiopose only

    bool operator==(const GeometryOptions&) const = default;
};

/// Whether the vessels are bent onto the image after a rigid registration (ALGORITHMS §11).
enum class Deformation {
    Off,
    Auto,   ///< where a fit of angiopose without locks looks as if they were bent (§11.5)
    Always
};

/// Which method runs, what every method reads, and the settings of each. Described for users by optionFields().
struct RegistrationOptions {
    std::string method = "angiopose";

    double pointSpacingMm = 1.0;   ///< tree points are this far apart
    double targetSpacingPx = 1.0;   ///< target points are this far apart
    bool resample = true;   ///< points evenly spaced as above, or as they are
    int maxIterations = 60;
    double finalScalePx = 1.0;   ///< kernel width at which the annealing ends
    int randomSeed = 1;   ///< of the methods that draw lots

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

    PoseLocks locks{};   ///< degrees of freedom that stay as they are at the start; for all methods but a few

    bool operator==(const RegistrationOptions&) const = default;
};

}   // namespace angiopose::core