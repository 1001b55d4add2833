#pragma once

#include "core/registration/alignment/coarse_search.h"

namespace angiopose::core {

/// Exhaustive search like CoarseSearch, but in the opposite direction (ALGORITHMS §6.17): scores how close each traced
/// vessel is to a projected branch of similar direction. Unopacified branches do not lower the score; a single
/// opacified territory of the tree is therefore enough to find a pose. If both widths are known, pairs of different
/// width score lower.
class TerritorySearch {
public:
    /// `radiusPx` holds the radius of each target line, 0 if unknown; it may be empty.
    TerritorySearch(const ProjectionCamera& camera, const TargetLines& target, std::span<const double> radiusPx = {});

    /// Like CoarseSearch::find; the scores are the mean closeness of the target to the tree. `radiusMm` holds the
    /// radius of each point, 0 if unknown; it may be empty.
    std::vector<CoarseCandidate> find(std::span<const AlignmentPoint> points, std::span<const double> radiusMm,
                                      const CentroidPose& start, const SearchRange& range,
                                      const std::function<ObserverDecision(double)>& observe);

private:
    static constexpr std::size_t directions = 4;   ///< vessel directions, 45° apart

    /// Target point in cells of the canvas.
    struct TargetPoint {
        int column, row;
        std::size_t channel;   ///< index combining width and direction
    };
    using Stamp = std::vector<std::uint8_t>;
    struct Shifts;
    std::size_t widthBin(double radiusPx);
    void compareWidths(std::span<const double> radiusMm, double pxPerMm, std::size_t points);
    void allocateCanvas(int halfShift);
    void drawTree(std::span<const AlignmentPoint> points, const CentroidPose& pose);
    void stamp(int column, int row, const Stamp& closeness, std::uint8_t* channel) const;
    void sumShifts(Shifts& shifts) const;
    void keepBest(const CentroidPose& pose, const Shifts& shifts, std::vector<CoarseCandidate>& candidates) const;

    ProjectionCamera camera_;
    int cellPx_;
    std::vector<TargetPoint> targetPoints_;   ///< evenly spaced subset of the target points
    std::vector<double> logWidths_;   ///< widths of the target, each with its own channels; NaN for an unknown width
    std::vector<std::uint8_t> widthsMatch_;   ///< per tree point and target width, 1 if they match
    Stamp sameWidthStamp_;   ///< closeness 0…255 around a tree point
    Stamp otherWidthStamp_;   ///< closeness for vessels of a different width
    int margin_ = 0;   ///< number of cells added around the image
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::uint8_t> canvas_;   ///< closeness to the projected tree, one image per width and direction
};

}   // namespace angiopose::core
