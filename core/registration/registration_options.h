#pragma once

#include "core/geometry/pose_axis.h"
#include "core/support/message.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::core {

/// How the prior of the seed is weighed against the data (ALGORITHMS §2, decision 17).
enum class PriorPreset { SeedSum, SeedMean, SeedMetric, NoPrior };

/// Which tree points the alternating search solves by themselves (ALGORITHMS §3.2): the branches the user chose, or the
/// nodes where none is chosen; the nodes; the widest branches, up to a third of the length; random points.
enum class AuxiliarySet { Chosen, Nodes, MainBranches, Random };

/// Settings of every method; each method reads those that the table below gives it.
struct RegistrationOptions {
    std::string method = "angiopose";

    double pointSpacingMm = 1.0;   ///< tree points are this far apart
    double targetSpacingPx = 1.0;   ///< target points are this far apart
    double resample = 1;   ///< 1: points evenly spaced as above, 0: as they are
    int maxIterations = 60;
    double finalScalePx = 1.0;   ///< kernel width at which the annealing ends

    // dynaweight, iterative-pnp
    double preset = 1;   ///< index into PriorPreset
    double priorWeight = 100.0;   ///< λ of the pull towards the start pose
    double rotationFirst = 1;   ///< 1: a rotation-only solve comes first
    double alternation = 1;   ///< 1: auxiliary and full problem take turns
    double index = 0;   ///< index into IndexKind: how nearest points are found
    double startScale = 1;   ///< index into StartScale
    double decay = 0;   ///< index into Decay: when the kernel narrows

    double neighbours = 0;   ///< index into Neighbours: how many target points pull each tree point

    // every method that alternates
    double auxiliary = 0;   ///< index into AuxiliarySet
    int auxiliaryCount = 60;   ///< points of AuxiliarySet::Random

    // dt-icp, assembled-icp
    int icpIterations = 100;
    double alternate = 0;   ///< 1: inside the alternating search
    double huberPx = 5.0;   ///< distance from which pulls stop growing
    double icpSolver = 0;   ///< 0: Levenberg–Marquardt with fresh matches, 1: L-BFGS on the squared distances
    double icpModel = 0;   ///< 0: rigid, 1: an affine stage follows, its rigid part is kept if it fits better

    // nicp, nicp-alternating
    double nicpImage = 0;   ///< 0: attracted by the traced vessels, 1: by the brightness of the image
    double nicpStep = 0;   ///< 0: turns and shifts in balance, 1: raw radians and millimetres
    double nicpPrior = 0;   ///< 1: with the prior of `preset` and `priorWeight`
    double nicpStartScalePx = 20.0;
    double nicpFinalScalePx = 3.0;
    int nicpIterations = 300;   ///< per scale

    // rgbr
    double rgbrReachMm = 20.0;   ///< first search along the normals
    int rgbrHypotheses = 500;
    int rgbrRounds = 30;

    // automask
    double automaskSample = 100.0;   ///< % of the mask
    double automaskMarginPx = 8.0;
    int automaskEvaluations = 1000;

    // gradient-matching
    double gradientScalePx = 1.5;
    int powellRounds = 20;

    // ogmm
    double ogmmStartScalePx = 15.0;
    double ogmmFinalScalePx = 0.5;
    double ogmmOrientation = 0.3;   ///< kernel width of the directions
    double ogmmSelfWeight = 1.0;   ///< of the term that keeps the projected tree from collapsing

    // evolution
    double evolutionStrategy = 0;   ///< 0: CMA-ES, 1: (1+1)
    int evolutionPopulation = 16;
    int evolutionEvaluations = 3000;

    // particle
    double particleSearch = 0;   ///< 0: annealed particle filter, 1: over the out-of-plane angles (Tian)
    int particles = 500;
    int particleRounds = 8;

    int randomSeed = 1;   ///< of the methods that draw lots

    // angiopose
    double search = 1;   ///< 1: coarse search before refining, 0: refine the start pose only
    double searchRadiusMm = 130.0;   ///< lateral reach of the coarse search; only starts that do not fit need it
    double searchTiltDeg = 90.0;   ///< reach of the search in LAO/RAO and CRA/CAU
    double searchRollDeg = 180.0;   ///< reach of the search in roll
    double priorRotationDeg = 8.0;   ///< 1-σ of the start pose's rotation
    double priorLateralMm = 30.0;   ///< 1-σ of the start pose across the ray
    double priorDepthMm = 30.0;   ///< 1-σ of the start pose along the ray

    PoseLocks locks{};   ///< degrees of freedom that stay as they are at the start; for all methods but a few

    bool operator==(const RegistrationOptions&) const = default;
};

/// One option described once: panel, range check, command line and case file loop over the table.
struct OptionField {
    std::string_view key;   ///< in files and on the command line
    std::string_view label;   ///< in the window
    std::string_view unit;   ///< "px", "mm", "°" or empty
    std::string_view help;   ///< the effect, one sentence
    double min = 0.0;
    double max = 0.0;
    int decimals = 0;   ///< 0: whole numbers
    std::vector<std::string_view> choices;   ///< not empty: the value is an index into these
    std::vector<std::string_view> methods;   ///< ids it applies to; empty: all
    double (*read)(const RegistrationOptions&);
    void (*write)(RegistrationOptions&, double);
};

const std::vector<OptionField>& optionFields();

/// A method as users meet it.
struct MethodInfo {
    std::string_view id;   ///< FORMATS §5
    std::string_view label;   ///< "AngioPose", "DynaWeightPnP", …
    std::string_view summary;   ///< one sentence: what it minimises, its source
};

/// Every method that runs, the default first.
std::span<const MethodInfo> methodInfos();

/// The first setting that makes no sense, in words for the user; empty when all do.
std::optional<Message> findProblem(const RegistrationOptions& options);

}   // namespace angiopose::core