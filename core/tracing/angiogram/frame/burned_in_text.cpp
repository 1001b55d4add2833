#include "core/tracing/angiogram/frame/burned_in_text.h"

#include "core/imaging/mask_morphology.h"
#include "core/tracing/angiogram/frame/text_rows.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double extremeFraction = 0.02;   // tolerance around the extremes (lossy compression), fraction of the range
constexpr double minEdgeStep = 0.3;   // minimum intensity step across a shape's border, as a fraction of the range
constexpr double minInkEdgeStep = 0.12;   // same for shapes of one exact value, as X-ray images never contain
constexpr int inkLevels = 256;
constexpr int minInkPx = 40;
constexpr std::size_t maxInks = 3;
constexpr double minHardEdgeFraction = 0.8;   // minimum fraction of a shape's border with such a step
constexpr int minPixelsOfLetter = 4;
constexpr int minHeightPx = 5;
constexpr int textMarginPx = 3;

/// Returns the fraction of the pixels just outside the shape that differ from `value` by at least `step`, sampled two
/// pixels away because the border may be smoothed.
double hardEdgeFraction(const ImageF& frame, const Mask2d& drawn, const std::vector<std::size_t>& pixels, float value,
                        double step)
{
    int hard = 0;
    int all = 0;
    for (const std::size_t p : pixels) {
        const int x = static_cast<int>(p % static_cast<std::size_t>(frame.width));
        const int y = static_cast<int>(p / static_cast<std::size_t>(frame.width));
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const bool isBorder = frame.contains(x + 2 * dx, y + 2 * dy) && drawn.at(x + dx, y + dy) == 0 &&
                                  drawn.at(x + 2 * dx, y + 2 * dy) == 0;
            all += isBorder ? 1 : 0;
            hard += isBorder && std::abs(frame.at(x + 2 * dx, y + 2 * dy) - value) >= step ? 1 : 0;
        }
    }
    return all > 0 ? static_cast<double>(hard) / all : 0.0;
}

/// Possible value of burned-in text: pixels within `tolerance` of one value, with edges of at least `step`.
struct Ink {
    float value = 0.0F;
    float tolerance = 0.0F;
    double step = 0.0;
};

std::vector<Glyph> findGlyphs(const ImageF& frame, const Ink& ink, double maxLetterHeight)
{
    Mask2d drawn(frame.width, frame.height);
    for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
        drawn.pixels[i] = std::abs(frame.pixels[i] - ink.value) <= ink.tolerance ? 255 : 0;
    }
    const double greatest = maxLetterHeight * std::max(frame.width, frame.height);
    std::vector<Glyph> glyphs;
    for (const std::vector<std::size_t>& pixels : componentsOf(drawn)) {
        const Glyph glyph = boundsOf(pixels, frame.width);
        const bool isSmall = glyph.height() <= greatest && glyph.width() <= 2.0 * greatest;
        if (pixels.size() >= minPixelsOfLetter && isSmall && glyph.height() >= minHeightPx &&
            hardEdgeFraction(frame, drawn, pixels, ink.value, ink.step) >= minHardEdgeFraction) {
            glyphs.push_back(glyph);
        }
    }
    return glyphs;
}

/// Returns, for each value, the number of pixels with an equal neighbor on one side and a hard edge on the other.
std::vector<int> inkCounts(const ImageF& frame, float least, float range)
{
    std::vector<int> counts(inkLevels + 1);
    const auto step = static_cast<float>(minInkEdgeStep) * range;
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 2; x + 2 < frame.width; ++x) {
            const float value = frame.at(x, y);
            const bool endsLeft = frame.at(x + 1, y) == value && std::abs(frame.at(x - 2, y) - value) >= step;
            const bool endsRight = frame.at(x - 1, y) == value && std::abs(frame.at(x + 2, y) - value) >= step;
            if (endsLeft || endsRight) {
                ++counts[static_cast<std::size_t>((value - least) / range * inkLevels)];
            }
        }
    }
    return counts;
}

/// Returns the minimum and maximum values, and the values most frequent in flat shapes with hard edges.
std::vector<Ink> findInks(const ImageF& frame)
{
    const auto [least, greatest] = std::minmax_element(frame.pixels.begin(), frame.pixels.end());
    const float range = *greatest - *least;
    if (range <= 0.0F) {
        return {};
    }
    const auto extremeTolerance = static_cast<float>(extremeFraction) * range;
    std::vector<Ink> inks{{*least, extremeTolerance, minEdgeStep * range},
                          {*greatest, extremeTolerance, minEdgeStep * range}};
    std::vector<int> counts = inkCounts(frame, *least, range);
    for (std::size_t k = 0; k < maxInks; ++k) {
        const auto most = std::ranges::max_element(counts);
        if (*most < minInkPx) {
            break;
        }
        const float level = range / inkLevels;
        inks.push_back(
            {*least + (static_cast<float>(most - counts.begin()) + 0.5F) * level, level, minInkEdgeStep * range});
        *most = 0;
    }
    return inks;
}

void maskRow(Mask2d& text, const std::vector<Glyph>& row)
{
    Glyph box = row.front();
    for (const Glyph& glyph : row) {
        box = {std::min(box.left, glyph.left), std::max(box.right, glyph.right), std::min(box.top, glyph.top),
               std::max(box.bottom, glyph.bottom)};
    }
    const int margin = textMarginPx + box.height() / 2;   // includes accents, descenders and punctuation
    for (int y = std::max(0, box.top - margin); y <= std::min(text.height - 1, box.bottom + margin); ++y) {
        for (int x = std::max(0, box.left - margin); x <= std::min(text.width - 1, box.right + margin); ++x) {
            text.at(x, y) = 255;
        }
    }
}

}   // namespace

Mask2d burnedInTextMask(const ImageF& frame, double maxLetterHeight)
{
    Mask2d text(frame.width, frame.height);
    if (frame.isEmpty()) {
        return text;
    }
    for (const Ink& ink : findInks(frame)) {
        for (const std::vector<Glyph>& row : findTextRows(findGlyphs(frame, ink, maxLetterHeight))) {
            maskRow(text, row);
        }
    }
    return text;
}

}   // namespace angiopose::core
