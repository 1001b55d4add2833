#pragma once

#include "core/registration/alignment/coarse_search.h"

namespace angiopose::core {

/// Exhaustive search like CoarseSearch, but in the opposite direction (ALGORITHMS §6.17): scores the distance of the
/// traced vessels to the projected tree with a similar direction. Unopacified branches cost nothing; a single territory
/// of the tree is therefore enough to find a pose. Where both widths are known, vessels with a different width score
/// lower: a wide vessel is compared with wide branches.
class TerritorySearch {
public:
    /// `radiusPx` holds the radius of each target line, 0 where unknown; may be empty.
    TerritorySearch(const ProjectionCamera& camera, const TargetLines& target, std::span<const double> radiusPx = {});

    /// Like CoarseSearch::find; scores are the mean closeness of the target to the tree. `radiusMm` holds the radius of
    /// each point, 0 where unknown; may be empty.
    std::vector<CoarseCandidate> find(std::span<const AlignmentPoint> points, std::span<const double> radiusMm,
                                      const CentroidPose& start, const SearchReach& reach,
                                      const std::function<Verdict(double)>& proceed);

private:
    static constexpr std::size_t directions = 4;   ///< vessel directions, 45° apart

    /// Place of the target in cells of the canvas.
    struct Place {
        int column, row;
        std::size_t channel;   ///< combination of direction and width
    };
    using Stamp = std::vector<std::uint8_t>;
    struct Shifts;
    std::size_t widthOf(double radiusPx);
    void compareWidths(std::span<const double> radiusMm, double pxPerMm, std::size_t points);
    void layOut(int halfShift);
    void drawTree(std::span<const AlignmentPoint> points, const CentroidPose& pose);
    void stamp(int column, int row, const Stamp& closeness, std::uint8_t* channel) const;
    void sumShifts(Shifts& shifts) const;
    void keepBest(const CentroidPose& pose, const Shifts& shifts, std::vector<CoarseCandidate>& found) const;

    ProjectionCamera camera_;
    int cellPx_;
    std::vector<Place> places_;   ///< subset of the target's places, evenly spread
    std::vector<double> logWidths_;   ///< widths of the target, each with its own channels; NaN: unknown width
    std::vector<std::uint8_t> isLike_;   ///< 1 for each width that is compatible with each point
    Stamp like_;   ///< closeness 0…255 around a tree point
    Stamp unlike_;   ///< same for vessels of a different width
    int margin_ = 0;   ///< cells around the image
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::uint8_t> canvas_;   ///< closeness to the tree, per width and direction
};

}   // namespace angiopose::core
