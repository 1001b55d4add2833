#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Which pieces are traced where no seed asks for some. `Usual`: all of a mask, a label image or a surface; of a scan,
/// in which bone and veins are pieces too, the first great vessel's. `All` of a scan: those of every great vessel.
enum class TracedPieces { Usual, All, Largest };

/// What becomes of vessels that run in a circle.
enum class VesselLoops {
    Opened,   ///< each at its thinnest place
    Kept   ///< those that are no flaw of the lumen; the branch that closes one ends on another
};

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
    TracedPieces pieces = TracedPieces::Usual;
    VesselLoops loops = VesselLoops::Opened;
    bool tubesOnly = false;   ///< thin vessels alone, from the seeds: chambers, organs and wide vessels end them
    int threads = 0;   ///< 0: as many as the processor has; the result is the same for any number

    bool operator==(const VesselTracingOptions&) const = default;
};

}   // namespace angiopose::core
