#pragma once

#include "core/registration/alignment/coarse_search.h"

namespace angiopose::core {

/// Exhaustive search like CoarseSearch, asked the other way round (ALGORITHMS §6.17): how near the traced vessels come
/// to the projected tree, in a like direction. What the contrast medium does not fill costs nothing, so that a pose is
/// found from one territory of the tree.
class TerritorySearch {
public:
    TerritorySearch(const ProjectionCamera& camera, const TargetLines& target);

    /// As CoarseSearch::find; scores are the mean closeness of the target to the tree.
    std::vector<CoarseCandidate> find(std::span<const AlignmentPoint> points, const CentroidPose& start,
                                      const SearchReach& reach, const std::function<Verdict(double)>& proceed);

private:
    static constexpr int channels = 4;   ///< directions of vessels, each 45° from the next

    /// A place of the target in cells of the canvas.
    struct Place {
        int column, row, channel;
    };
    struct Shifts;
    void layOut(int halfShift);
    void drawTree(std::span<const AlignmentPoint> points, const CentroidPose& pose);
    void stamp(int column, int row, std::uint8_t* channel) const;
    void sumShifts(Shifts& shifts) const;
    void keepBest(const CentroidPose& pose, const Shifts& shifts, std::vector<CoarseCandidate>& found) const;

    ProjectionCamera camera_;
    int cellPx_;
    std::vector<Place> places_;   ///< some of the target's, spread evenly
    std::vector<std::uint8_t> stamp_;   ///< closeness 0…255 around a point of the tree
    int margin_ = 0;   ///< cells around the image
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::uint8_t> canvas_;   ///< closeness to the tree, channel by channel
};

}   // namespace angiopose::core
