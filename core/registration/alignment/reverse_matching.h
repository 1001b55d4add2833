#pragma once

#include "core/registration/alignment/projected_point.h"
#include "core/registration/alignment/projected_points.h"
#include "core/registration/matching/target_lines.h"

namespace angiopose::core {

/// Matches each target line to its nearest tree point. The matches are recomputed only after a point has moved in the
/// image: until then, a neighboring tree point gives the same distance across the branch.
class ReverseMatcher {
public:
    static constexpr std::size_t lineStride = 2;   ///< skips neighboring lines, whose noise is correlated

    /// Returns the buffer for the projected tree points, which the caller fills.
    std::vector<PointInCamera>& projected() { return projected_; }
    const std::vector<PointInCamera>& projected() const { return projected_; }

    /// Recomputes the matches for the current points if necessary.
    void match(const TargetLines& target, int width, int height, double reachPx);

    /// Returns the index of the nearest tree point for every `lineStride`-th line; −1 if none is within the search
    /// radius.
    const std::vector<int>& matches() const { return matches_; }

private:
    bool isUpToDate(double reachPx) const;

    std::vector<PointInCamera> projected_;
    std::vector<Eigen::Vector2d> matchedPositions_;   ///< positions of the points when the matches were computed
    double reachPx_ = 0.0;
    ProjectedPoints grid_;
    std::vector<int> matches_;
};

}   // namespace angiopose::core
