#pragma once

#include "core/registration/alignment/projected_point.h"
#include "core/registration/alignment/projected_points.h"
#include "core/registration/matching/target_lines.h"

namespace angiopose::core {

/// Nearest tree point of each target line. Recomputed only when a point has moved in the image: its neighbors give the
/// same distance across a branch, which is the one that counts.
class ReverseMatching {
public:
    static constexpr std::size_t lineStride = 2;   ///< neighboring lines have correlated noise

    /// Tree points, to be filled by the caller that projects them.
    std::vector<PointInCamera>& seen() { return seen_; }
    const std::vector<PointInCamera>& seen() const { return seen_; }

    /// Updates the partners for the current points.
    void match(const TargetLines& target, int width, int height, double reachPx);

    /// Index of the nearest point for every `lineStride`-th line, −1 if none is within the search radius.
    const std::vector<int>& partners() const { return partners_; }

private:
    bool isUpToDate(double reachPx) const;

    std::vector<PointInCamera> seen_;
    std::vector<Eigen::Vector2d> matchedAt_;   ///< positions of the points when the partners were computed
    double reachPx_ = 0.0;
    ProjectedPoints grid_;
    std::vector<int> partners_;
};

}   // namespace angiopose::core
