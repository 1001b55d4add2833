#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Draws along vessels by hand (intelligent scissors, Mortensen & Barrett 1998): from an anchor, the path of least cost
/// to wherever the pointer is, cheap on vessels. The search from the anchor goes on from call to call, as far as each
/// needs, so that a moving pointer mostly looks up; one call settles 120 000 pixels at most.
class LiveWire {
public:
    /// `vesselness` 0…1, as `traceAngiogram` gives it.
    explicit LiveWire(const ImageF& vesselness);

    /// Begins a new search where the vessel is strongest within a few px of `pointPx`.
    void setAnchor(const Eigen::Vector2d& pointPx);

    /// From the anchor to the strongest vesselness near `pointPx`, in steps of about 1 px; both ends included. Where
    /// the search has not come that far yet, the straight line; empty without an anchor.
    std::vector<Eigen::Vector2d> pathTo(const Eigen::Vector2d& pointPx);

private:
    using Pixel = std::uint32_t;
    static constexpr std::uint32_t bucketCount = 512;   ///< above the largest cost of a step

    Pixel snapped(const Eigen::Vector2d& pointPx) const;
    Eigen::Vector2d pointOf(Pixel pixel) const;
    bool searchUntil(Pixel target);
    void settle(Pixel pixel);

    Image2d<std::uint8_t> costs_;   ///< of one px, 1…255
    ImageF vesselness_;
    std::vector<std::uint32_t> distances_;
    std::vector<std::uint8_t> arrivals_;   ///< direction of the step that led here
    std::vector<std::uint8_t> settled_;
    std::array<std::vector<Pixel>, bucketCount> buckets_;   ///< by distance modulo their count (Dial 1969)
    std::uint32_t reachedDistance_ = 0;
    std::size_t waiting_ = 0;
    Pixel anchor_ = 0;
    bool hasAnchor_ = false;
};

}   // namespace angiopose::core