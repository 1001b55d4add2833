#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// One set of defaults for every scan.
struct VesselTracingOptions {
    std::optional<double> threshold =
        std::nullopt;   ///< lumen begins at this value (HU for CT); absent: found from the blood
    std::vector<Eigen::Vector3d> seedsInPatient =
        {};   ///< LPS mm; only vessels connected to one of them; none: those of the great vessel that is found
    std::vector<Eigen::Vector3d> avoidInPatient = {};   ///< LPS mm; what is reached from these on wider ways than from
                                                        ///< the seeds is no vessel: heart, vein, bone
    std::optional<Eigen::Vector3d> rootInPatient =
        std::nullopt;   ///< LPS mm; the end nearest to it is the root; absent: the thickest
    double minBranchLengthMm = 4.0;   ///< branches that leave their parent's wall by less are removed
    double minBranchRadiusMm = 0.0;   ///< branches that are thinner on average are removed
    double pointSpacingMm = 1.0;   ///< along the branches
    bool tubesOnly = false;   ///< thin vessels alone, from the seeds: chambers, organs and wide vessels end them
    int threads = 0;   ///< 0: as many as the processor has; the result is the same for any number

    bool operator==(const VesselTracingOptions&) const = default;
};

}   // namespace angiopose::core
