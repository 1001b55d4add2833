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
constexpr double minPaper = 0.7;   // minimum fraction of page color; a narrow field in a black frame is close
constexpr double inkContrast = 0.25;   // minimum difference of ink from the page, as a fraction of the gray range
constexpr double maxToneShare = 0.1;   // maximum fraction of pixels in shapes too large for letters (images, frames)
constexpr double greatestLetterShare = 0.05;   // maximum letter size, as a fraction of the longer side
constexpr std::size_t minLetters = 30;
constexpr double minInRows = 0.5;   // minimum fraction of letter-sized shapes in rows; specks do not form rows

/// Returns the predominant gray value, or nullopt if no value covers the required fraction of the image.
std::optional<float> paperOf(const ImageF& picture, float low, float range)
{
    std::array<std::size_t, grayLevels> counts{};
    for (const float value : picture.pixels) {
        ++counts[std::min(grayLevels - 1, static_cast<std::size_t>((value - low) / range * grayLevels))];
    }
    const auto most = std::ranges::max_element(counts);
    if (static_cast<double>(*most) < minPaper * static_cast<double>(picture.pixels.size())) {
        return {};
    }
    return low + (static_cast<float>(most - counts.begin()) + 0.5F) * range / grayLevels;
}

Mask2d inkOn(const ImageF& picture, float paper, float range)
{
    Mask2d ink(picture.width, picture.height);
    std::ranges::transform(picture.pixels, ink.pixels.begin(), [&](float value) {
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

bool isReportPage(const ImageF& picture)
{
    if (picture.isEmpty()) {
        return false;
    }
    const auto [low, high] = std::ranges::minmax_element(picture.pixels);
    const float range = *high - *low;
    const auto paper = range > 0.0F ? paperOf(picture, *low, range) : std::nullopt;
    if (!paper) {
        return false;
    }
    const double greatest = greatestLetterShare * std::max(picture.width, picture.height);
    std::vector<Glyph> glyphs;
    std::size_t tonePx = 0;   // pixels in shapes too large for letters
    for (const std::vector<std::size_t>& shape : componentsOf(inkOn(picture, *paper, range))) {
        const Glyph bounds = boundsOf(shape, picture.width);
        if (bounds.height() <= greatest && bounds.width() <= greatest) {
            if (shape.size() >= 4 && bounds.height() >= 4) {
                glyphs.push_back(bounds);
            }
        } else {
            tonePx += shape.size();
        }
    }
    const std::size_t letters = letterCount(textRows(glyphs));
    return letters >= minLetters && static_cast<double>(letters) >= minInRows * static_cast<double>(glyphs.size()) &&
           static_cast<double>(tonePx) <= maxToneShare * static_cast<double>(picture.pixels.size());
}

}   // namespace angiopose::core
