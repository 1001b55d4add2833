#pragma once

#include "core/imaging/volume.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::test {

/// A variant of a scan of the same patient, as from another device, protocol or export; positions in the patient do not
/// change.
struct ScanChange {
    std::string name;
    std::function<core::Volume(const core::Volume&)> apply;
};

/// Changes of axis order, spacing, cropping, values and noise; the unchanged scan comes first. Seeded: identical at
/// every call.
std::vector<ScanChange> scanChanges();

}   // namespace angiopose::test
