#pragma once

#include "core/simulation/simulated_case.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::app {

/// ByHeader: writes no initial pose; it follows from the header's geometry.
enum class SimulatedStart { Written, ByHeader };

/// Writes case.angiopose with its inputs tree.vtp and angiogram.dcm, and the ground truth: true-pose.json,
/// true-centreline.csv and, for deformed vessels, true-vessels.vtp. Creates the folder. Never overwrites a case that is
/// open elsewhere.
core::Status writeSimulatedCase(const core::SimulatedCase& simulated, const std::string& title,
                                const std::string& folder, SimulatedStart start = SimulatedStart::Written);

}   // namespace angiopose::app
