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
struct Contestant {
    std::string label;   ///< as it was asked for: "angiopose", "dynaweight:seed_noprior", …
    RegistrationOptions options;
    bool choosesSpacing = false;   ///< the request says whether to resample; otherwise the trial does
};

/// From "method", followed by settings after colons: "key=value", or the mere name of a choice that only one option of
/// the method has ("dynaweight:seed_noprior:rotationFirst=off"). Fails naming what is unknown.
Result<Contestant> contestantFrom(const std::string& request);

/// Requests separated by commas. Groups: "all" is every method but that for wires with its defaults, and DynaWeightPnP
/// without its prior besides, "ablation" the settings of
/// ALGORITHMS §2: {preset} × {rotation first} × {alternation} of DynaWeightPnP.
Result<std::vector<Contestant>> contestantsFrom(const std::string& requests);

/// The options for one trial: published point-to-point solvers take exact targets as they are, so that exact partners
/// exist; all else is resampled.
RegistrationOptions optionsFor(const Contestant& contestant, bool targetIsExact);

enum class KeepHistory { No, Yes };

/// Registers one trial with one method and measures the errors; the caller fills in condition, trial and anatomy.
/// Nothing when `isStopped` came true before the method was done.
std::optional<RunRecord> runTrial(const Trial& trial, const Contestant& contestant, KeepHistory keepHistory,
                                  const std::function<bool()>& isStopped);

}   // namespace angiopose::core
