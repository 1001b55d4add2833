#pragma once

#include "core/vessel/vessel_input.h"

#include <string>

namespace angiopose::io {

/// Every key this version reads and writes, as a JSON object; an empty string marks a value, an object its members.
std::string knownCaseKeys(core::VesselInputKind vesselKind);

/// Likewise of a view that stands in the case.
std::string knownViewKeys();

}   // namespace angiopose::io