#pragma once

#include "core/registration/alignment/branch_pieces.h"

#include <cstdint>
#include <span>

namespace angiopose::core {

/// Which of the tree the contrast medium fills. Where it does not come to, all that it feeds stays empty: neighbouring
/// pieces are alike unless the image speaks against it, and every change along the tree costs (ALGORITHMS §6.17).
class VesselFilling {
public:
    explicit VesselFilling(const TreeSamples& tree);

    /// The piece of every tree point.
    const std::vector<int>& pieceOfPoint() const { return pieceOfPoint_; }
    const std::vector<BranchPiece>& pieces() const { return parts_.pieces; }

    /// 1 for each piece that is most likely filled, by how much more each piece looks filled than empty (any sign; in
    /// the unit of `changeCost`, mm of vessel). Exact: dynamic programme over the tree.
    std::vector<std::uint8_t> likeliest(std::span<const double> filledGain, double changeCost) const;

    /// Connected empty stretches of at least `minMm`.
    int emptyTerritories(std::span<const std::uint8_t> isOpacified, double minMm) const;

    /// Junctions at which at least three filled pieces meet.
    int forks(std::span<const std::uint8_t> isOpacified) const;

    double lengthMm(std::size_t piece) const { return lengthMm_[piece]; }

private:
    /// Pieces first, then junctions; every node after the one it hangs on.
    struct Node {
        int number;
        int above;   ///< the node it hangs on; −1: none
    };

    BranchPieces parts_;
    std::vector<int> pieceOfPoint_;
    std::vector<double> lengthMm_;
    std::vector<Node> order_;
};

}   // namespace angiopose::core
