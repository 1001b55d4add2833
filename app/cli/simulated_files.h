#pragma once

#include "core/simulation/simulated_case.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::app {

/// ByHeader: no start pose is written, it follows from the geometry of the header.
enum class SimulatedStart { Written, ByHeader };

/// Writes case.angiopose with its inputs tree.vtp and angiogram.dcm, and what is true: true-pose.json and
/// true-centreline.csv, of deformed vessels true-vessels.vtp. Makes the folder. Writes over no case that is open
/// elsewhere.
core::Status writeSimulatedCase(const core::SimulatedCase& simulated, const std::string& title,
                                const std::string& folder, SimulatedStart start = SimulatedStart::Written);

}   // namespace angiopose::app
