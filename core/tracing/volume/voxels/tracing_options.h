#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Connected components to trace if no seed selects them. `Usual`: all of a mask, label image or surface; for a scan,
/// whose components include bone and veins, those of the first great vessel. `All` of a scan: those of every great
/// vessel.
enum class TracedPieces { Usual, All, Largest };

/// Treatment of vessels that form loops.
enum class VesselLoops {
    Opened,   ///< each at its thinnest place
    Kept   ///< unless a flaw of the lumen; the closing branch ends on another
};

/// Default tracing options for every scan.
struct VesselTracingOptions {
    std::optional<double> threshold =
        std::nullopt;   ///< lower limit of the lumen (HU for CT); absent: derived from the blood
    std::vector<Eigen::Vector3d> seedsInPatient =
        {};   ///< LPS mm; only vessels connected to a seed; empty: the great vessel found
    std::vector<Eigen::Vector3d> avoidInPatient = {};   ///< LPS mm; in heart, vein or bone (see `splitBySeeds`)
    std::optional<Eigen::Vector3d> rootInPatient =
        std::nullopt;   ///< LPS mm; the nearest end is the root; absent: the thickest
    double minBranchLengthMm = 4.0;   ///< branches that protrude less from their parent's wall are removed
    double minBranchRadiusMm = 0.0;   ///< branches with a lower mean radius are removed
    double pointSpacingMm = 1.0;   ///< along the branches
    TracedPieces pieces = TracedPieces::Usual;
    VesselLoops loops = VesselLoops::Opened;
    bool tubesOnly = false;   ///< only thin vessels from the seeds, ending at chambers, organs and wide vessels
    int threads = 0;   ///< 0: one per processor core; the result does not depend on it

    bool operator==(const VesselTracingOptions&) const = default;
};

}   // namespace angiopose::core
