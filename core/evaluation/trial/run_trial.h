#pragma once

#include "core/evaluation/trial/contestant.h"
#include "core/evaluation/trial/run_record.h"
#include "core/evaluation/trial/trial.h"

#include <functional>
#include <optional>

namespace angiopose::core {

enum class KeepHistory { No, Yes };

/// Registers one trial with one method and measures the errors; the caller fills in condition, trial and anatomy.
/// Nothing when `isStopped` came true before the method was done.
std::optional<RunRecord> runTrial(const Trial& trial, const Contestant& contestant, KeepHistory keepHistory,
                                  const std::function<bool()>& isStopped);

}   // namespace angiopose::core