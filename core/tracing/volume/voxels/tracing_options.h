#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Connected components to trace if no seed selects them. `Usual` for a mask, label image or surface: all components;
/// for a scan, whose components include bone and veins: those of the first great vessel. `All` for a scan: those of
/// every great vessel.
enum class TracedPieces { Usual, All, Largest };

/// Treatment of vessels that form loops.
enum class VesselLoops {
    Opened,   ///< cut at the thinnest point
    Kept   ///< kept unless due to a segmentation flaw; the closing branch ends on another branch
};

/// Default tracing options for every scan.
struct VesselTracingOptions {
    std::optional<double> threshold =
        std::nullopt;   ///< lower limit of the lumen (HU for CT); if unset, derived from the lumen level
    std::vector<Eigen::Vector3d> seedsInPatient =
        {};   ///< LPS, mm; traces only vessels connected to a seed. If empty, traces from the detected great vessel.
    std::vector<Eigen::Vector3d> avoidInPatient = {};   ///< LPS, mm; points in heart, vein or bone (see `splitBySeeds`)
    std::optional<Eigen::Vector3d> rootInPatient =
        std::nullopt;   ///< LPS, mm; the nearest end becomes the root; if unset, the end of the thickest vessel
    double minBranchLengthMm = 4.0;   ///< branches that protrude less from their parent's wall are removed
    double minBranchRadiusMm = 0.0;   ///< branches with a lower mean radius are removed
    double pointSpacingMm = 1.0;   ///< spacing along the branches
    TracedPieces pieces = TracedPieces::Usual;
    VesselLoops loops = VesselLoops::Opened;
    bool tubesOnly = false;   ///< traces only thin vessels from the seeds, ending at chambers, organs and wide vessels
    int threads = 0;   ///< number of threads; 0 for one per processor core; does not affect the result

    bool operator==(const VesselTracingOptions&) const = default;
};

}   // namespace angiopose::core
