#pragma once

#include "core/registration/alignment/coarse_search.h"

namespace angiopose::core {

/// Exhaustive search like CoarseSearch, asked the other way round (ALGORITHMS §6.17): how near the traced vessels come
/// to the projected tree, in a like direction. What the contrast medium does not fill costs nothing, so that a pose is
/// found from one territory of the tree. Where both tell widths, vessels of an unlike one come less near: a wide vessel
/// is looked for among wide ones.
class TerritorySearch {
public:
    /// `radiusPx`: of each of the target's lines, 0 where unknown; or none.
    TerritorySearch(const ProjectionCamera& camera, const TargetLines& target, std::span<const double> radiusPx = {});

    /// As CoarseSearch::find; scores are the mean closeness of the target to the tree. `radiusMm`: of each point, 0
    /// where unknown; or none.
    std::vector<CoarseCandidate> find(std::span<const AlignmentPoint> points, std::span<const double> radiusMm,
                                      const CentroidPose& start, const SearchReach& reach,
                                      const std::function<Verdict(double)>& proceed);

private:
    static constexpr std::size_t directions = 4;   ///< of vessels, each 45° from the next

    /// A place of the target in cells of the canvas.
    struct Place {
        int column, row;
        std::size_t channel;   ///< a direction of a width
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
    std::vector<Place> places_;   ///< some of the target's, spread evenly
    std::vector<double> logWidths_;   ///< of the target's, each with its own channels; NaN: of unknown width
    std::vector<std::uint8_t> isLike_;   ///< 1 for each width of each point that a vessel there may well be seen with
    Stamp like_;   ///< closeness 0…255 around a point of the tree
    Stamp unlike_;   ///< the same for vessels of another width
    int margin_ = 0;   ///< cells around the image
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::uint8_t> canvas_;   ///< closeness to the tree: per width, per direction
};

}   // namespace angiopose::core
