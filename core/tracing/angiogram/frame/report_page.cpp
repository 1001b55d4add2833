#include "core/tracing/angiogram/frame/report_page.h"

#include "core/imaging/mask_morphology.h"
#include "core/tracing/angiogram/frame/text_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace angiopose::core {
namespace {

constexpr std::size_t grayLevels = 64;   // histogram bins for finding the gray value of the page
constexpr double minPaperFraction = 0.7;   // minimum fraction of page color; a narrow field in a black frame is close
constexpr double inkContrast = 0.25;   // minimum difference of ink from the page, as a fraction of the gray range
constexpr double maxToneFraction = 0.1;   // maximum fraction of pixels in shapes too large for letters (images, frames)
constexpr double maxLetterFraction = 0.05;   // maximum letter size, as a fraction of the longer side
constexpr std::size_t minLetters = 30;
constexpr double minFractionInRows = 0.5;   // minimum fraction of letter-sized shapes in rows; specks do not form rows

/// Returns the predominant gray value, or nullopt if no value covers the required fraction of the image.
std::optional<float> findPaperLevel(const ImageF& image, float low, float range)
{
    std::array<std::size_t, grayLevels> counts{};
    for (const float value : image.pixels) {
        ++counts[std::min(grayLevels - 1, static_cast<std::size_t>((value - low) / range * grayLevels))];
    }
    const auto modeBin = std::ranges::max_element(counts);
    if (static_cast<double>(*modeBin) < minPaperFraction * static_cast<double>(image.pixels.size())) {
        return {};
    }
    return low + (static_cast<float>(modeBin - counts.begin()) + 0.5F) * range / grayLevels;
}

Mask2d findInk(const ImageF& image, float paper, float range)
{
    Mask2d ink(image.width, image.height);
    std::ranges::transform(image.pixels, ink.pixels.begin(), [&](float value) {
        return static_cast<std::uint8_t>(std::abs(value - paper) >= inkContrast * range ? 255 : 0);
    });
    return ink;
}

std::size_t letterCount(const std::vector<std::vector<Glyph>>& rows)
{
    std::size_t count = 0;
    for (const std::vector<Glyph>& row : rows) {
        count += row.size();
    }
    return count;
}

}   // namespace

bool isReportPage(const ImageF& image)
{
    if (image.isEmpty()) {
        return false;
    }
    const auto [low, high] = std::ranges::minmax_element(image.pixels);
    const float range = *high - *low;
    const auto paper = range > 0.0F ? findPaperLevel(image, *low, range) : std::nullopt;
    if (!paper) {
        return false;
    }
    const double maxLetterPx = maxLetterFraction * std::max(image.width, image.height);
    std::vector<Glyph> glyphs;
    std::size_t tonePx = 0;   // pixels in shapes too large for letters
    for (const std::vector<std::size_t>& shape : componentsOf(findInk(image, *paper, range))) {
        const Glyph bounds = boundsOf(shape, image.width);
        if (bounds.height() <= maxLetterPx && bounds.width() <= maxLetterPx) {
            if (shape.size() >= 4 && bounds.height() >= 4) {
                glyphs.push_back(bounds);
            }
        } else {
            tonePx += shape.size();
        }
    }
    const std::size_t letters = letterCount(findTextRows(glyphs));
    return letters >= minLetters &&
           static_cast<double>(letters) >= minFractionInRows * static_cast<double>(glyphs.size()) &&
           static_cast<double>(tonePx) <= maxToneFraction * static_cast<double>(image.pixels.size());
}

}   // namespace angiopose::core
