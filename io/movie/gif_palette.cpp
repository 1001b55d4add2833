#include "io/movie/gif_palette.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace angiopose::io {
namespace {

using Color = GifPalette::Color;

constexpr std::size_t maxColors = 255;
constexpr std::size_t minGrays = 127;   // covers the full range in steps of at most 2 levels, which prevents banding
constexpr int grayTolerance = 8;   // maximum difference between channels of a color that looks gray
constexpr std::uint16_t unknown = 0xFFFF;
constexpr int cellBits = 5;   // bits per channel of the histogram cells
constexpr int keyBits = 6;   // bits per channel of the nearest-color cache

bool isGray(const Color& color)
{
    const auto [least, most] = std::ranges::minmax(color);
    return most - least <= grayTolerance;
}

std::size_t keyOf(const Color& color, int bits)
{
    std::size_t key = 0;
    for (const std::uint8_t channel : color) {
        key = (key << bits) | static_cast<std::size_t>(channel >> (8 - bits));
    }
    return key;
}

/// Sum and number of the colors in one cell of the color cube.
struct Cell {
    std::array<double, 3> sum{};
    double count = 0.0;

    double mean(std::size_t channel) const { return sum[channel] / count; }
};

/// A part of the color cube that gets one palette entry.
struct Box {
    std::size_t first = 0;
    std::size_t last = 0;   ///< index past the last cell
    std::size_t widest = 0;   ///< channel with the largest spread
    double spread = 0.0;   ///< sum of squared deviations along that channel
};

/// Returns the square root of the color count, so that long lines do not outweigh small objects of a distinct color.
double weightOf(const Cell& cell)
{
    return std::sqrt(cell.count);
}

Box boxOf(std::span<const Cell> cells, std::size_t first, std::size_t last)
{
    Box box{first, last};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        double sum = 0.0, squares = 0.0, weights = 0.0;
        for (const Cell& cell : cells.subspan(first, last - first)) {
            const double weight = weightOf(cell), value = cell.mean(channel);
            sum += weight * value;
            squares += weight * value * value;
            weights += weight;
        }
        const double spread = squares - sum * sum / weights;
        if (last - first > 1 && spread > box.spread) {
            box.spread = spread;
            box.widest = channel;
        }
    }
    return box;
}

Color meanOf(std::span<const Cell> cells)
{
    Cell all;
    for (const Cell& cell : cells) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            all.sum[channel] += cell.sum[channel];
        }
        all.count += cell.count;
    }
    Color color{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        color[channel] = static_cast<std::uint8_t>(std::lround(all.mean(channel)));
    }
    return color;
}

/// Returns colors by median cut: repeatedly splits the box with the largest spread where that best halves the spread.
std::vector<Color> chosenColors(std::vector<Cell> cells, std::size_t most)
{
    std::vector<Color> colors;
    if (cells.empty()) {
        return colors;
    }
    std::vector<Box> boxes{boxOf(cells, 0, cells.size())};
    while (boxes.size() < most) {
        const auto widest = std::ranges::max_element(boxes, {}, &Box::spread);
        if (widest->spread <= 0.0) {
            break;
        }
        const Box parted = *widest;
        const auto part = std::span(cells).subspan(parted.first, parted.last - parted.first);
        std::ranges::sort(part, {}, [channel = parted.widest](const Cell& cell) { return cell.mean(channel); });
        const double middle = 0.5 * (part.front().mean(parted.widest) + part.back().mean(parted.widest));
        const auto upper =
            std::ranges::find_if(part, [&](const Cell& cell) { return cell.mean(parted.widest) > middle; });
        const auto lower = std::clamp<std::ptrdiff_t>(upper - part.begin(), 1, std::ssize(part) - 1);
        const std::size_t cut = parted.first + static_cast<std::size_t>(lower);
        *widest = boxOf(cells, parted.first, cut);
        boxes.push_back(boxOf(cells, cut, parted.last));
    }
    for (const Box& box : boxes) {
        colors.push_back(meanOf(std::span(cells).subspan(box.first, box.last - box.first)));
    }
    return colors;
}

/// Returns all gray levels that occur, or evenly spaced ones if more than `most` levels occur.
std::vector<int> chosenGrays(const std::array<std::size_t, 256>& counts, std::size_t most)
{
    std::vector<int> grays;
    for (int gray = 0; gray < 256; ++gray) {
        if (counts[static_cast<std::size_t>(gray)] > 0) {
            grays.push_back(gray);
        }
    }
    if (grays.size() <= most) {
        return grays;
    }
    const int first = grays.front(), last = grays.back();
    grays.clear();
    for (std::size_t i = 0; i < most; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(most - 1);
        grays.push_back(first + static_cast<int>(std::lround(part * (last - first))));
    }
    return grays;
}

int luma(const Color& color)
{
    return (color[0] + color[1] + color[2] + 1) / 3;
}

int distance(const Color& a, const Color& b)
{
    const int red = a[0] - b[0], green = a[1] - b[1], blue = a[2] - b[2];
    return 3 * red * red + 4 * green * green + 2 * blue * blue;   // approximate perceptual weights
}

/// Histogram of the gray levels, with the cells of all other colors.
struct Counted {
    std::array<std::size_t, 256> grays{};
    std::vector<Cell> others;
};

Counted countColors(const core::ColorImage& image)
{
    Counted counted;
    counted.others.resize(std::size_t{1} << (3 * cellBits));
    for (std::size_t at = 0; at + 2 < image.rgb.size(); at += 3) {
        const Color color{image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
        if (isGray(color)) {
            ++counted.grays[static_cast<std::size_t>(luma(color))];
            continue;
        }
        Cell& cell = counted.others[keyOf(color, cellBits)];
        for (std::size_t channel = 0; channel < 3; ++channel) {
            cell.sum[channel] += color[channel];
        }
        ++cell.count;
    }
    std::erase_if(counted.others, [](const Cell& cell) { return cell.count == 0.0; });
    return counted;
}

}   // namespace

GifPalette::GifPalette(const core::ColorImage& image) : nearest_(std::size_t{1} << (3 * keyBits), unknown)
{
    Counted counted = countColors(image);
    const auto graysThere =
        static_cast<std::size_t>(std::ranges::count_if(counted.grays, [](auto n) { return n > 0; }));
    const std::size_t left = maxColors - std::min(maxColors, counted.others.size());
    const std::vector<int> grays = chosenGrays(counted.grays, std::max(std::min(graysThere, minGrays), left));
    for (const int gray : grays) {
        const auto value = static_cast<std::uint8_t>(gray);
        colors_.push_back({value, value, value});
    }
    hasGrays_ = !grays.empty();
    for (std::size_t gray = 0; hasGrays_ && gray < nearestGray_.size(); ++gray) {
        const auto nearest =
            std::ranges::min_element(grays, {}, [gray](int each) { return std::abs(each - static_cast<int>(gray)); });
        nearestGray_[gray] = static_cast<std::uint8_t>(nearest - grays.begin());
    }
    const std::vector<Color> others = chosenColors(std::move(counted.others), maxColors - colors_.size());
    colors_.insert(colors_.end(), others.begin(), others.end());
}

std::uint8_t GifPalette::indexOf(const Color& color)
{
    if (hasGrays_ && isGray(color)) {
        return nearestGray_[static_cast<std::size_t>(luma(color))];
    }
    std::uint16_t& known = nearest_[keyOf(color, keyBits)];
    if (known == unknown) {
        const auto nearest =
            std::ranges::min_element(colors_, {}, [&color](const Color& each) { return distance(each, color); });
        known = static_cast<std::uint16_t>(nearest - colors_.begin());
    }
    return static_cast<std::uint8_t>(known);
}

}   // namespace angiopose::io
