#include "core/imaging/mask_morphology.h"

#include <algorithm>
#include <array>

namespace core {
namespace {

struct Step {
    int dx;
    int dy;
};
constexpr std::array<Step, 8> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

/// Pixels reached from `seed` over pixels that are set (or clear) as the seed is; marks them as seen.
std::vector<std::size_t> flood(const Mask2d& mask, std::size_t seed, std::size_t neighbours, Mask2d& seen)
{
    const bool wanted = mask.pixels[seed] != 0;
    std::vector<std::size_t> reached{seed};
    seen.pixels[seed] = 255;
    for (std::size_t next = 0; next < reached.size(); ++next) {
        const int x = static_cast<int>(reached[next] % static_cast<std::size_t>(mask.width));
        const int y = static_cast<int>(reached[next] / static_cast<std::size_t>(mask.width));
        for (std::size_t k = 0; k < neighbours; ++k) {
            if (!mask.contains(x + steps[k].dx, y + steps[k].dy)) {
                continue;
            }
            const std::size_t index = mask.index(x + steps[k].dx, y + steps[k].dy);
            if (seen.pixels[index] == 0 && (mask.pixels[index] != 0) == wanted) {
                seen.pixels[index] = 255;
                reached.push_back(index);
            }
        }
    }
    return reached;
}

bool onImageEdge(const Mask2d& mask, std::size_t index)
{
    const int x = static_cast<int>(index % static_cast<std::size_t>(mask.width));
    const int y = static_cast<int>(index / static_cast<std::size_t>(mask.width));
    return x == 0 || y == 0 || x == mask.width - 1 || y == mask.height - 1;
}

struct Region {
    std::vector<std::size_t> pixels;
    bool isHole = true;
};

/// The background around `seed`, given up as no hole once it grows beyond the area, to the image edge or into `open`.
Region smallRegion(const Mask2d& mask, const Mask2d& open, std::size_t seed, std::size_t maxArea)
{
    const auto width = static_cast<std::size_t>(mask.width);
    Region region{{seed}, true};
    for (std::size_t next = 0; next < region.pixels.size() && region.isHole; ++next) {
        const std::size_t p = region.pixels[next];
        if (onImageEdge(mask, p) || open.pixels[p] != 0 || region.pixels.size() > maxArea) {
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

enum class Target { Clear, Set };

/// Where pixels of the kind `sought` occur within ±radius along a row of `mask`, into the same row of `result`.
void spreadRow(const Mask2d& mask, int y, int radius, Target sought, Mask2d& result)
{
    const bool wanted = sought == Target::Set;
    int until = -1;
    for (int x = -radius; x < mask.width; ++x) {
        const int ahead = x + radius;
        if (ahead < mask.width && (mask.at(ahead, y) != 0) == wanted) {
            until = ahead + radius;
        }
        if (x >= 0) {
            result.at(x, y) = (until >= x) == wanted ? 255 : 0;
        }
    }
}

/// The same along all columns at once, row after row.
Mask2d spreadColumns(const Mask2d& mask, int radius, Target sought)
{
    const bool wanted = sought == Target::Set;
    std::vector<int> until(static_cast<std::size_t>(mask.width), -1);
    Mask2d result(mask.width, mask.height);
    for (int y = -radius; y < mask.height; ++y) {
        const int ahead = y + radius;
        for (int x = 0; x < mask.width && ahead < mask.height; ++x) {
            if ((mask.at(x, ahead) != 0) == wanted) {
                until[static_cast<std::size_t>(x)] = ahead + radius;
            }
        }
        for (int x = 0; x < mask.width && y >= 0; ++x) {
            result.at(x, y) = (until[static_cast<std::size_t>(x)] >= y) == wanted ? 255 : 0;
        }
    }
    return result;
}

Mask2d spread(const Mask2d& mask, int radius, Target sought)
{
    Mask2d rows(mask.width, mask.height);
    for (int y = 0; y < mask.height; ++y) {
        spreadRow(mask, y, radius, sought, rows);
    }
    return spreadColumns(rows, radius, sought);
}

}   // namespace

Mask2d eroded(const Mask2d& mask, int radiusPx)
{
    return mask.isEmpty() ? mask : spread(mask, radiusPx, Target::Clear);
}

Mask2d dilated(const Mask2d& mask, int radiusPx)
{
    return mask.isEmpty() ? mask : spread(mask, radiusPx, Target::Set);
}

Mask2d connectedToEdge(const Mask2d& mask)
{
    Mask2d seen(mask.width, mask.height);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
        if (mask.pixels[i] != 0 && seen.pixels[i] == 0 && onImageEdge(mask, i)) {
            flood(mask, i, 8, seen);
        }
    }
    return seen;
}

Mask2d withHolesFilled(Mask2d mask, int maxAreaPx)
{
    Mask2d open(mask.width, mask.height);   // background known to be too large for a hole
    for (std::size_t p = 1; p < mask.pixels.size(); ++p) {
        const bool besideMask = mask.pixels[p] == 0 && mask.pixels[p - 1] != 0;   // every hole has such a pixel
        if (!besideMask || open.pixels[p] != 0) {
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
            components.push_back(flood(mask, i, 8, seen));
        }
    }
    return components;
}

}   // namespace core
