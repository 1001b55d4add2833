#pragma once

#include "core/evaluation/trial/run_record.h"
#include "core/registration/options/registration_options.h"
#include "core/support/result.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// A method in an experiment, with its settings.
struct EvaluatedMethod {
    std::string label;   ///< label as requested: "angiopose", "dynaweight:seed_noprior", …
    RegistrationOptions options;
    bool hasExplicitResampling =
        false;   ///< whether the request sets the resampling; otherwise the trial determines it
};

/// Parses a method id followed by settings, separated by colons. A setting is "key=value", or only the name of a choice
/// if a single option of the method has that choice ("dynaweight:seed_noprior:rotationFirst=off"). The error names the
/// unknown part.
Result<EvaluatedMethod> parseMethod(const std::string& request);

/// Parses requests separated by commas. The group "all" stands for every method with its defaults, except the one for
/// guidewires, plus DynaWeightPnP without its prior. The group "ablation" stands for the settings of ALGORITHMS §2:
/// {preset} × {rotation first} × {alternation} of DynaWeightPnP.
Result<std::vector<EvaluatedMethod>> parseMethods(const std::string& requests);

/// Returns the options for one trial: published point-to-point solvers use exact targets without resampling, which
/// gives exact correspondences; all other methods use resampled targets.
RegistrationOptions optionsFor(const EvaluatedMethod& evaluatedMethod, bool targetIsExact);

enum class KeepHistory { No, Yes };

/// Registers one trial with one method and computes the errors; the caller fills in condition, trial and anatomy.
/// Returns nullopt if `isStopped` became true before the method finished.
std::optional<RunRecord> runTrial(const Trial& trial, const EvaluatedMethod& evaluatedMethod, KeepHistory keepHistory,
                                  const std::function<bool()>& isStopped);

}   // namespace angiopose::core
