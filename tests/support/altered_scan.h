#pragma once

#include "core/imaging/volume.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::test {

/// Another scan of the same patient, as another device, protocol or export would have left it; what was at a place in
/// the patient stays there.
struct ScanChange {
    std::string name;
    std::function<core::Volume(const core::Volume&)> apply;
};

/// Axis orders, spacings, parts, values and noise; "as it is" comes first. Seeded: the same at every call.
std::vector<ScanChange> scanChanges();

}   // namespace angiopose::test