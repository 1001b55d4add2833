#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/support/verdict.h"
#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
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
    int threads = 0;   ///< 0: as many as the processor has; the result is the same for any number

    bool operator==(const VesselTracingOptions&) const = default;
};

struct TracingReport {
    std::string_view stage;   ///< "blood", "vessels", "thinning", "branches"
    double progress = 0.0;   ///< 0…1, never decreasing
};

/// Called on the calling thread, several times a second; its Stop ends the work within a second.
using TracingObserver = std::function<Verdict(const TracingReport&)>;

/// A vessel tree with what was seen on the way to it.
struct TracedVessels {
    VesselTree tree;   ///< root first, then by generation; ids 1, 2, …; radii, patient LPS
    VoxelMask lumen;   ///< the voxels that were traced, in the geometry of the input
    double threshold = 0.0;   ///< the value at which the lumen begins; 0.5 for masks
    std::optional<Eigen::Vector3d>
        foundStart;   ///< without seeds: a place in the great vessel that was begun at, LPS mm
    Messages warnings;   ///< pieces that were left out, loops that were opened, …
};

/// Contrast-filled vessels of a CT angiogram: threshold or seeded growth, bone and table left out, thinning, a tree of
/// smooth centrelines with radii. Without seeds the tree is that of the vessel most like an aorta (see `Trunk::worth`),
/// else of the largest piece; a warning says which. Fails on an empty or flat volume, seeds outside the lumen, when
/// nothing is like a vessel (the axes of that piece hold no blood); ends as stopped when the observer says so, then
/// nothing is kept. Needs at most twice the volume's own memory besides it.
Result<TracedVessels> traceVessels(const Volume& volume, const VesselTracingOptions& options = {},
                                   const TracingObserver& observe = {});

/// A mask of vessels, taken as it is: its largest piece, or the pieces that hold the seeds.
Result<TracedVessels> traceMask(const VoxelMask& mask, const VesselTracingOptions& options = {},
                                const TracingObserver& observe = {});

/// The vessels of a label image that carry one of `labels`; none given: any label.
Result<TracedVessels> traceLabels(const LabelVolume& image, const std::vector<int>& labels,
                                  const VesselTracingOptions& options = {}, const TracingObserver& observe = {});

}   // namespace angiopose::core