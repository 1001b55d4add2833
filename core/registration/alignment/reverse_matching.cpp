#include "core/registration/alignment/reverse_matching.h"

namespace angiopose::core {
namespace {

constexpr double maxPointMotionPx = 0.5;   // smaller than the spacing of points and lines

}   // namespace

bool ReverseMatcher::isUpToDate(double reachPx) const
{
    if (reachPx != reachPx_ || matchedPositions_.size() != projected_.size()) {
        return false;
    }
    for (std::size_t i = 0; i < projected_.size(); ++i) {
        const double du = projected_[i].u - matchedPositions_[i].x();
        const double dv = projected_[i].v - matchedPositions_[i].y();
        if (!(du * du + dv * dv < maxPointMotionPx * maxPointMotionPx)) {
            return false;
        }
    }
    return true;
}

void ReverseMatcher::match(const TargetLines& target, int width, int height, double reachPx)
{
    if (isUpToDate(reachPx)) {
        return;
    }
    reachPx_ = reachPx;
    matchedPositions_.clear();
    matchedPositions_.reserve(projected_.size());
    grid_.reserve(projected_.size());
    grid_.reset(width, height, reachPx);
    for (std::size_t i = 0; i < projected_.size(); ++i) {
        matchedPositions_.emplace_back(projected_[i].u, projected_[i].v);
        if (projected_[i].isInFront && projected_[i].hasDirection) {
            grid_.add({projected_[i].u, projected_[i].v, static_cast<int>(i)});
        }
    }
    matches_.clear();
    const auto& lines = target.lines();
    matches_.reserve(lines.size() / lineStride + 1);
    for (std::size_t j = 0; j < lines.size(); j += lineStride) {
        const ProjectedPoint* nearest = grid_.nearest(lines[j].x, lines[j].y);
        matches_.push_back(nearest == nullptr ? -1 : nearest->number);
    }
}

}   // namespace angiopose::core
