#include "tests/support/drawn_vessels.h"

#include "core/imaging/image_filters.h"
#include "core/support/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::test {

Path line(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    return {from, to};
}

Path circle(const Eigen::Vector2d& center, double radius)
{
    Path path;
    for (int i = 0; i <= 90; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 90.0;
        path.push_back(center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    return path;
}

double distanceTo(const Path& path, const Eigen::Vector2d& point)
{
    double nearest = (path.front() - point).norm();
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Eigen::Vector2d chord = path[i] - path[i - 1];
        const double along = std::clamp((point - path[i - 1]).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (path[i - 1] + along * chord - point).norm());
    }
    return nearest;
}

core::ImageF drawnFrame(int width, int height, const std::vector<Path>& paths, double radiusPx, const FrameLook& look)
{
    core::ImageF shadow(width, height);
    constexpr int samples = 3;
    for (const Path& path : paths) {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                if (distanceTo(path, {x, y}) > radiusPx + 1.0) {
                    continue;
                }
                for (int k = 0; k < samples * samples; ++k) {
                    const Eigen::Vector2d offset(k % samples - 1, k / samples - 1);
                    const double ratio = distanceTo(path, Eigen::Vector2d(x, y) + offset / samples) / radiusPx;
                    shadow.at(x, y) += static_cast<float>(std::sqrt(std::max(0.0, 1.0 - ratio * ratio))) / 9.0F;
                }
            }
        }
    }
    core::ImageF frame = core::gaussianBlur(shadow, look.blurPx);
    for (float& value : frame.pixels) {
        value = look.background - look.depth * value;
    }
    addNoise(frame, look.noise, 1);
    return frame;
}

void addNoise(core::ImageF& image, double sigma, std::uint64_t seed)
{
    core::CounterRandom random(seed);
    for (float& value : image.pixels) {
        value += static_cast<float>(sigma * random.normal());
    }
}

}   // namespace angiopose::test
