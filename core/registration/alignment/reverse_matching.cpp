#include "core/registration/alignment/reverse_matching.h"

namespace angiopose::core {
namespace {

constexpr double keptPartnersPx = 0.5;   // smaller than the spacing of points and lines

}   // namespace

bool ReverseMatching::isUpToDate(double reachPx) const
{
    if (reachPx != reachPx_ || matchedAt_.size() != seen_.size()) {
        return false;
    }
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        const double du = seen_[i].u - matchedAt_[i].x();
        const double dv = seen_[i].v - matchedAt_[i].y();
        if (!(du * du + dv * dv < keptPartnersPx * keptPartnersPx)) {
            return false;
        }
    }
    return true;
}

void ReverseMatching::match(const TargetLines& target, int width, int height, double reachPx)
{
    if (isUpToDate(reachPx)) {
        return;
    }
    reachPx_ = reachPx;
    matchedAt_.clear();
    matchedAt_.reserve(seen_.size());
    grid_.reserve(seen_.size());
    grid_.restart(width, height, reachPx);
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        matchedAt_.emplace_back(seen_[i].u, seen_[i].v);
        if (seen_[i].isInFront && seen_[i].hasDirection) {
            grid_.add({seen_[i].u, seen_[i].v, static_cast<int>(i)});
        }
    }
    partners_.clear();
    const auto& lines = target.lines();
    partners_.reserve(lines.size() / lineStride + 1);
    for (std::size_t j = 0; j < lines.size(); j += lineStride) {
        const ProjectedPoint* nearest = grid_.nearest(lines[j].x, lines[j].y);
        partners_.push_back(nearest == nullptr ? -1 : nearest->number);
    }
}

}   // namespace angiopose::core
