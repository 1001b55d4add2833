#pragma once

#include "core/tracing/angiogram/evidence/vessel_network.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// Networks of which each was trained without some of the annotated angiograms, which it therefore may judge.
class FoldNetworks {
public:
    /// From a folder whose folds.txt names in each line a network's file and the images that it never saw. Nothing, and
    /// a line on stderr, where that cannot be read.
    static std::optional<FoldNetworks> read(const std::filesystem::path& folder);

    /// Those that some network may judge, ascending.
    std::vector<int> images() const;

    /// The one that never saw the image; null if there is none.
    const core::VesselNetwork* unbiasedFor(int image) const;

private:
    std::map<std::string, core::VesselNetwork> networks_;
    std::map<int, std::string> networkOfImage_;
};

}   // namespace angiopose::benchmarks
