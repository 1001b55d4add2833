#include "core/tracing/angiogram/drawing/live_wire.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr int snapReachPx = 4;
constexpr double snapFalloffPx = 6.0;   // distance from the pointer at which the snap weight falls to 0
constexpr std::size_t maxSettledPerCall = 120000;   // about 11 ms, to keep the window responsive
constexpr double maxPixelCost = 240.0;
constexpr std::uint32_t unreachedPixel = std::numeric_limits<std::uint32_t>::max();

struct WireStep {
    int dx;
    int dy;
};
constexpr std::array<WireStep, 8> wireSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

/// Assigns low costs to vessels and high costs beside them. The square root lets faint vessels guide the path as well.
Image2d<std::uint8_t> costsOf(const ImageF& vesselness)
{
    Image2d<std::uint8_t> costs(vesselness.width, vesselness.height);
    for (std::size_t i = 0; i < costs.pixels.size(); ++i) {
        const double strength = std::sqrt(std::clamp<double>(vesselness.pixels[i], 0.0, 1.0));
        costs.pixels[i] = static_cast<std::uint8_t>(std::lround(4.0 + maxPixelCost * std::pow(1.0 - strength, 3)));
    }
    return costs;
}

std::vector<Eigen::Vector2d> straightLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm())));
    std::vector<Eigen::Vector2d> line;
    for (int k = 0; k <= count; ++k) {
        line.emplace_back(from + (to - from) * k / count);
    }
    return line;
}

}   // namespace

LiveWire::LiveWire(const ImageF& vesselness)
    : costs_(costsOf(vesselness)),
      vesselness_(vesselness),
      distances_(vesselness.pixels.size()),
      arrivalSteps_(vesselness.pixels.size()),
      settled_(vesselness.pixels.size())
{
}

void LiveWire::setAnchor(const Eigen::Vector2d& pointPx)
{
    hasAnchor_ = !vesselness_.isEmpty();
    if (!hasAnchor_) {
        return;
    }
    std::fill(distances_.begin(), distances_.end(), unreachedPixel);
    std::fill(settled_.begin(), settled_.end(), std::uint8_t{0});
    for (std::vector<Pixel>& bucket : buckets_) {
        bucket.clear();
    }
    anchor_ = snapToVessel(pointPx);
    distances_[anchor_] = 0;
    reachedDistance_ = 0;
    buckets_[0].push_back(anchor_);
    queuedCount_ = 1;
}

std::vector<Eigen::Vector2d> LiveWire::pathTo(const Eigen::Vector2d& pointPx)
{
    if (!hasAnchor_) {
        return {};
    }
    Pixel pixel = snapToVessel(pointPx);
    if (!extendSearchTo(pixel)) {
        return straightLine(pointOf(anchor_), pointOf(pixel));
    }
    std::vector<Eigen::Vector2d> path{pointOf(pixel)};
    while (pixel != anchor_) {
        const WireStep& step = wireSteps[arrivalSteps_[pixel]];
        pixel = static_cast<Pixel>(static_cast<std::int64_t>(pixel) - step.dx -
                                   static_cast<std::int64_t>(step.dy) * vesselness_.width);
        path.push_back(pointOf(pixel));
    }
    std::reverse(path.begin(), path.end());
    return path;
}

LiveWire::Pixel LiveWire::snapToVessel(const Eigen::Vector2d& pointPx) const
{
    const int x0 = std::clamp(static_cast<int>(std::lround(pointPx.x())), 0, vesselness_.width - 1);
    const int y0 = std::clamp(static_cast<int>(std::lround(pointPx.y())), 0, vesselness_.height - 1);
    std::size_t best = vesselness_.index(x0, y0);
    double bestStrength = vesselness_.pixels[best];
    for (int y = std::max(0, y0 - snapReachPx); y <= std::min(vesselness_.height - 1, y0 + snapReachPx); ++y) {
        for (int x = std::max(0, x0 - snapReachPx); x <= std::min(vesselness_.width - 1, x0 + snapReachPx); ++x) {
            const double distance = std::hypot(x - x0, y - y0);
            const double strength = vesselness_.at(x, y) * (1.0 - distance / snapFalloffPx);
            if (strength > bestStrength) {
                bestStrength = strength;
                best = vesselness_.index(x, y);
            }
        }
    }
    return static_cast<Pixel>(best);
}

Eigen::Vector2d LiveWire::pointOf(Pixel pixel) const
{
    const auto width = static_cast<Pixel>(vesselness_.width);
    const Pixel row = pixel / width;
    return {static_cast<double>(pixel % width), static_cast<double>(row)};
}

bool LiveWire::extendSearchTo(Pixel target)
{
    std::size_t count = 0;
    while (settled_[target] == 0 && queuedCount_ > 0 && count < maxSettledPerCall) {
        std::vector<Pixel>& bucket = buckets_[reachedDistance_ % bucketCount];
        if (bucket.empty()) {
            ++reachedDistance_;
            continue;
        }
        const Pixel pixel = bucket.back();
        bucket.pop_back();
        --queuedCount_;
        if (settled_[pixel] == 0) {
            settle(pixel);
            ++count;
        }
    }
    return settled_[target] != 0;
}

void LiveWire::settle(Pixel pixel)
{
    settled_[pixel] = 1;
    const int x = static_cast<int>(pixel % static_cast<Pixel>(vesselness_.width));
    const int y = static_cast<int>(pixel / static_cast<Pixel>(vesselness_.width));
    for (std::size_t k = 0; k < wireSteps.size(); ++k) {
        if (!vesselness_.contains(x + wireSteps[k].dx, y + wireSteps[k].dy)) {
            continue;
        }
        const std::size_t next = vesselness_.index(x + wireSteps[k].dx, y + wireSteps[k].dy);
        const std::uint32_t cost = costs_.pixels[next];
        const std::uint32_t distance = distances_[pixel] + (k < 4 ? cost : cost * 181 / 128);   // √2 on the diagonal
        if (distance < distances_[next]) {
            distances_[next] = distance;
            arrivalSteps_[next] = static_cast<std::uint8_t>(k);
            buckets_[distance % bucketCount].push_back(static_cast<Pixel>(next));
            ++queuedCount_;
        }
    }
}

}   // namespace angiopose::core
