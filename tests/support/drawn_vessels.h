#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace angiopose::test {

struct FrameLook {
    float background = 120.0F;
    float depth = 60.0F;   ///< darkening at the axis of a vessel
    double blurPx = 0.7;   ///< standard deviation of the point spread function
    double noise = 0.0;   ///< standard deviation
};

using Path = std::vector<Eigen::Vector2d>;

Path line(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
Path circle(const Eigen::Vector2d& center, double radius);

/// A frame with dark round tubes (absorption along the chord) along the paths; absorption adds up at crossings.
core::ImageF drawnFrame(int width, int height, const std::vector<Path>& paths, double radiusPx,
                        const FrameLook& look = {});

void addNoise(core::ImageF& image, double sigma, std::uint64_t seed);

/// Distance from a point to the path, with linear segments between its points.
double distanceTo(const Path& path, const Eigen::Vector2d& point);

}   // namespace angiopose::test
