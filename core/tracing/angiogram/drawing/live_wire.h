#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Live-wire tool for drawing along vessels (intelligent scissors, Mortensen & Barrett 1998): finds the path of least
/// cost, which is low on vessels, from an anchor to the pointer. Each call extends the search only as far as needed, so
/// a moving pointer mostly reads stored results; one call settles at most 120 000 pixels.
class LiveWire {
public:
    /// `vesselness` ranges from 0 to 1, as returned by `traceAngiogram`.
    explicit LiveWire(const ImageF& vesselness);

    /// Starts a new search at the strongest vesselness within a few px of `pointPx`.
    void setAnchor(const Eigen::Vector2d& pointPx);

    /// Returns the path from the anchor to the strongest vesselness near `pointPx`, in steps of about 1 px, including
    /// both ends. A straight line if the search has not reached that point yet; empty without an anchor.
    std::vector<Eigen::Vector2d> pathTo(const Eigen::Vector2d& pointPx);

private:
    using Pixel = std::uint32_t;
    static constexpr std::uint32_t bucketCount = 512;   ///< larger than the maximum cost of a step

    Pixel snapToVessel(const Eigen::Vector2d& pointPx) const;
    Eigen::Vector2d pointOf(Pixel pixel) const;
    bool extendSearchTo(Pixel target);
    void settle(Pixel pixel);

    Image2d<std::uint8_t> costs_;   ///< cost of one px, 1…255
    ImageF vesselness_;
    std::vector<std::uint32_t> distances_;
    std::vector<std::uint8_t> arrivalSteps_;   ///< direction of the step by which the pixel was reached
    std::vector<std::uint8_t> settled_;
    std::array<std::vector<Pixel>, bucketCount> buckets_;   ///< by distance modulo `bucketCount` (Dial 1969)
    std::uint32_t reachedDistance_ = 0;
    std::size_t queuedCount_ = 0;
    Pixel anchor_ = 0;
    bool hasAnchor_ = false;
};

}   // namespace angiopose::core
