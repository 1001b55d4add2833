#include "core/imaging/mask_morphology.h"

#include "core/imaging/window_maximum.h"

#include <algorithm>
#include <array>

namespace angiopose::core {
namespace {

struct NeighborStep {
    int dx;
    int dy;
};
constexpr std::array<NeighborStep, 8> morphologySteps{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

/// Returns the pixels connected to `seed` with the same state (set or clear) and marks them in `seen`.
std::vector<std::size_t> floodFill(const Mask2d& mask, std::size_t seed, std::size_t neighbors, Mask2d& seen)
{
    const bool wanted = mask.pixels[seed] != 0;
    std::vector<std::size_t> reached{seed};
    seen.pixels[seed] = 255;
    for (std::size_t next = 0; next < reached.size(); ++next) {
        const int x = static_cast<int>(reached[next] % static_cast<std::size_t>(mask.width));
        const int y = static_cast<int>(reached[next] / static_cast<std::size_t>(mask.width));
        for (std::size_t k = 0; k < neighbors; ++k) {
            if (!mask.contains(x + morphologySteps[k].dx, y + morphologySteps[k].dy)) {
                continue;
            }
            const std::size_t index = mask.index(x + morphologySteps[k].dx, y + morphologySteps[k].dy);
            if (seen.pixels[index] == 0 && (mask.pixels[index] != 0) == wanted) {
                seen.pixels[index] = 255;
                reached.push_back(index);
            }
        }
    }
    return reached;
}

bool isOnImageEdge(const Mask2d& mask, std::size_t index)
{
    const int x = static_cast<int>(index % static_cast<std::size_t>(mask.width));
    const int y = static_cast<int>(index / static_cast<std::size_t>(mask.width));
    return x == 0 || y == 0 || x == mask.width - 1 || y == mask.height - 1;
}

struct Region {
    std::vector<std::size_t> pixels;
    bool isHole = true;
};

/// Grows the background region around `seed`. It is not a hole if it exceeds `maxArea` or reaches the edge or `open`.
Region smallRegion(const Mask2d& mask, const Mask2d& open, std::size_t seed, std::size_t maxArea)
{
    const auto width = static_cast<std::size_t>(mask.width);
    Region region{{seed}, true};
    for (std::size_t next = 0; next < region.pixels.size() && region.isHole; ++next) {
        const std::size_t p = region.pixels[next];
        if (isOnImageEdge(mask, p) || open.pixels[p] != 0 || region.pixels.size() > maxArea) {
            region.isHole = false;
            break;
        }
        for (const std::size_t q : {p - 1, p + 1, p - width, p + width}) {
            const bool known = std::find(region.pixels.begin(), region.pixels.end(), q) != region.pixels.end();
            if (mask.pixels[q] == 0 && !known) {
                region.pixels.push_back(q);
            }
        }
    }
    return region;
}

void bitwiseOr(std::uint8_t* target, const std::uint8_t* pixels, int count)
{
    for (int i = 0; i < count; ++i) {
        target[i] |= pixels[i];
    }
}

/// Dilates a mask with values 0 and 255.
Mask2d dilateBinary(const Mask2d& mask, int radiusPx)
{
    return windowMaximum(mask, radiusPx, bitwiseOr);
}

Mask2d invert(const Mask2d& mask)
{
    Mask2d result(mask.width, mask.height);
    std::transform(mask.pixels.begin(), mask.pixels.end(), result.pixels.begin(),
                   [](std::uint8_t value) { return value != 0 ? std::uint8_t{0} : std::uint8_t{255}; });
    return result;
}

}   // namespace

Mask2d erode(const Mask2d& mask, int radiusPx)
{
    return invert(dilateBinary(invert(mask), radiusPx));
}

Mask2d dilate(const Mask2d& mask, int radiusPx)
{
    return dilateBinary(invert(invert(mask)), radiusPx);
}

Mask2d edgeComponents(const Mask2d& mask)
{
    Mask2d seen(mask.width, mask.height);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
        if (mask.pixels[i] != 0 && seen.pixels[i] == 0 && isOnImageEdge(mask, i)) {
            floodFill(mask, i, 8, seen);
        }
    }
    return seen;
}

Mask2d fillSmallHoles(Mask2d mask, int maxAreaPx)
{
    Mask2d open(mask.width, mask.height);   // background regions known to be too large for a hole
    for (std::size_t p = 1; p < mask.pixels.size(); ++p) {
        const bool isNextToMask = mask.pixels[p] == 0 && mask.pixels[p - 1] != 0;   // every hole contains such a pixel
        if (!isNextToMask || open.pixels[p] != 0) {
            continue;
        }
        const Region region = smallRegion(mask, open, p, static_cast<std::size_t>(maxAreaPx));
        for (const std::size_t q : region.pixels) {
            (region.isHole ? mask : open).pixels[q] = 255;
        }
    }
    return mask;
}

std::vector<std::vector<std::size_t>> componentsOf(const Mask2d& mask)
{
    std::vector<std::vector<std::size_t>> components;
    Mask2d seen(mask.width, mask.height);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
        if (mask.pixels[i] != 0 && seen.pixels[i] == 0) {
            components.push_back(floodFill(mask, i, 8, seen));
        }
    }
    return components;
}

}   // namespace angiopose::core
