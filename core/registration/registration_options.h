#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace core {

/// How the prior of the seed is weighed against the data (ALGORITHMS §2, decision 17).
enum class PriorPreset { SeedSum, SeedMean, SeedMetric, NoPrior };

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
    double startScale = 0;   ///< index into StartScale
    double decay = 0;   ///< index into Decay: when the kernel narrows

    // angiopose
    double search = 1;   ///< 1: coarse search before refining, 0: refine the start pose only
    double searchRadiusMm = 130.0;   ///< lateral reach of the coarse search; only starts that do not fit need it
    double searchTiltDeg = 10.0;   ///< reach of the coarse search in LAO/RAO and CRA/CAU
    double searchRollDeg = 10.0;   ///< reach of the coarse search in roll
    double priorRotationDeg = 8.0;   ///< 1-σ of the start pose's rotation
    double priorLateralMm = 30.0;   ///< 1-σ of the start pose across the ray
    double priorDepthMm = 30.0;   ///< 1-σ of the start pose along the ray

    int threads = 1;   ///< never changes the result

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
std::string findProblem(const RegistrationOptions& options);

}   // namespace core
