#pragma once

#include "core/registration/alignment/branch_pieces.h"

#include <cstdint>
#include <span>

namespace angiopose::core {

/// Determines which parts of the tree are opacified. Contrast agent that does not reach a piece does not reach anything
/// downstream either: neighboring pieces have the same state unless the image contradicts it, and every change along
/// the tree has a cost (ALGORITHMS §6.17).
class VesselFilling {
public:
    explicit VesselFilling(const TreeSamples& tree);

    /// Piece index of every tree point.
    const std::vector<int>& pieceOfPoint() const { return pieceOfPoint_; }
    const std::vector<BranchPiece>& pieces() const { return parts_.pieces; }

    /// Returns 1 for each piece that is most likely opacified. `filledGain` is the evidence that a piece is opacified
    /// rather than unopacified (any sign; in the unit of `changeCost`, mm of vessel). Exact: dynamic programming over
    /// the tree.
    std::vector<std::uint8_t> likeliest(std::span<const double> filledGain, double changeCost) const;

    /// Number of connected unopacified stretches of at least `minMm`.
    int emptyTerritories(std::span<const std::uint8_t> isOpacified, double minMm) const;

    /// Number of junctions at which at least three opacified pieces meet.
    int forks(std::span<const std::uint8_t> isOpacified) const;

    double lengthMm(std::size_t piece) const { return lengthMm_[piece]; }

private:
    /// Pieces first, then junctions; every node follows its parent.
    struct Node {
        int number;
        int above;   ///< parent node; −1: none
    };

    BranchPieces parts_;
    std::vector<int> pieceOfPoint_;
    std::vector<double> lengthMm_;
    std::vector<Node> order_;
};

}   // namespace angiopose::core
