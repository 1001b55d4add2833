#pragma once

#include "core/registration/alignment/projected_point.h"
#include "core/registration/alignment/projected_points.h"
#include "core/registration/matching/target_lines.h"

namespace angiopose::core {

/// Which tree point each line of the target is nearest to. Found anew only when a point has moved in the image since:
/// across a branch, which is what counts, its neighbours say the same.
class ReverseMatching {
public:
    static constexpr std::size_t lineStride = 2;   ///< neighbouring lines share their noise

    /// The tree's points, filled in by who projects them.
    std::vector<SeenPoint>& seen() { return seen_; }
    const std::vector<SeenPoint>& seen() const { return seen_; }

    /// Brings the partners up to date with the points.
    void match(const TargetLines& target, int width, int height, double reachPx);

    /// Of every `lineStride`-th line: the number of its point, −1 where none is within the reach.
    const std::vector<int>& partners() const { return partners_; }

private:
    bool isUpToDate(double reachPx) const;

    std::vector<SeenPoint> seen_;
    std::vector<Eigen::Vector2d> matchedAt_;   ///< where the points were when the partners were found
    double reachPx_ = 0.0;
    ProjectedPoints grid_;
    std::vector<int> partners_;
};

}   // namespace angiopose::core
