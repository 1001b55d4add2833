#pragma once

#include "core/registration/alignment/branch_segments.h"

#include <cstdint>
#include <span>

namespace angiopose::core {

/// Determines which parts of the tree are opacified (ALGORITHMS §6.17). If contrast agent does not reach a segment, it
/// does not reach the segments downstream either; neighboring segments therefore share the same state unless the image
/// contradicts it, and every change of state along the tree has a cost.
class OpacificationModel {
public:
    explicit OpacificationModel(const TreeSamples& tree);

    /// Returns the segment index of every tree point.
    const std::vector<int>& segmentOfPoint() const { return segmentOfPoint_; }
    const std::vector<BranchSegment>& pieces() const { return segments_.pieces; }

    /// Returns 1 for each segment that is most likely opacified. `opacifiedGain` is the evidence for opacified over
    /// unopacified, with either sign and in the unit of `changeCost`, mm of vessel. The solution is exact (dynamic
    /// programming over the tree).
    std::vector<std::uint8_t> likeliestStates(std::span<const double> opacifiedGain, double changeCost) const;

    /// Returns the number of connected unopacified territories of at least `minMm`.
    int countUnopacifiedTerritories(std::span<const std::uint8_t> isOpacified, double minMm) const;

    /// Returns the number of junctions at which at least three opacified segments meet.
    int countOpacifiedBifurcations(std::span<const std::uint8_t> isOpacified) const;

    double lengthMm(std::size_t piece) const { return lengthMm_[piece]; }

private:
    /// Tree node; the segments are numbered first, then the junctions. Every node follows its parent.
    struct Node {
        int number;
        int above;   ///< parent node; −1 for a root
    };

    BranchSegments segments_;
    std::vector<int> segmentOfPoint_;
    std::vector<double> lengthMm_;
    std::vector<Node> nodes_;
};

}   // namespace angiopose::core
