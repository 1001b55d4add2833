#include "ui/scenes/burn_text.h"

#include "ui/scenes/residual_scale.h"
#include "ui/scenes/text_mask.h"
#include "ui/theme/theme.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace angiopose::ui {

BurnSizes burnSizes(int width, int height)
{
    const int textPx = std::max(10, static_cast<int>(std::lround(0.0155 * std::min(width, height))));
    return {textPx, textPx};
}

namespace {

constexpr double baselineShare = 1.05;   // baseline below the top of a line, as a share of the text size

void blend(core::ColorImage& image, int x, int y, const Color& color, double share)
{
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) {
        return;
    }
    std::uint8_t* pixel = &image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                          static_cast<std::size_t>(x))];
    const Color result = mixed({pixel[0], pixel[1], pixel[2]}, color, share);
    pixel[0] = result.red;
    pixel[1] = result.green;
    pixel[2] = result.blue;
}

struct Rect {
    int left, top, width, height;
};

void fill(core::ColorImage& image, const Rect& rect, const Color& color, double share)
{
    for (int y = rect.top; y < rect.top + rect.height; ++y) {
        for (int x = rect.left; x < rect.left + rect.width; ++x) {
            blend(image, x, y, color, share);
        }
    }
}

void fill(VectorImage& image, const Rect& rect, const Color& color, double share)
{
    image.fills.push_back(
        {{1.0 * rect.left, 1.0 * rect.left + rect.width, 1.0 * rect.top, 1.0 * rect.top + rect.height}, color, share});
}

/// Lines of text with their rendered mask, whose size is that of the block.
struct TextBlock {
    TextBlock(std::vector<std::string> textLines, int px, TextAlign side)
        : lines(std::move(textLines)), sizePx(px), align(side), mask(textMask(lines, px, side))
    {
    }
    std::vector<std::string> lines;
    int sizePx;
    TextAlign align;
    core::Mask2d mask;
    Color tone = palette(ThemeMode::Dark).textStrong;
};

void drawText(VectorImage& image, const TextBlock& text, int left, int top)
{
    if (text.mask.isEmpty()) {
        return;
    }
    fill(image, {left - 4, top - 3, text.mask.width + 8, text.mask.height + 6}, palette(ThemeMode::Dark).canvas, 0.4);
    const double lineHeight = static_cast<double>(text.mask.height) / static_cast<double>(text.lines.size());
    const double start = text.align == TextAlign::Left ? left : left + text.mask.width - 2;
    for (std::size_t i = 0; i < text.lines.size(); ++i) {
        image.texts.push_back({text.lines[i],
                               {start, top + lineHeight * static_cast<double>(i) + baselineShare * text.sizePx},
                               text.align,
                               text.sizePx,
                               text.tone});
    }
}

void drawText(core::ColorImage& image, const TextBlock& text, int left, int top)
{
    const core::Mask2d& mask = text.mask;
    if (mask.isEmpty()) {
        return;
    }
    const Palette& colors = palette(ThemeMode::Dark);
    fill(image, {left - 4, top - 3, mask.width + 8, mask.height + 6}, colors.canvas, 0.4);
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            blend(image, left + x, top + y, text.tone, mask.at(x, y) / 255.0);
        }
    }
}

std::string formatted(double value, int decimals, char decimalSign)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    std::replace(std::begin(text), std::end(text), '.', decimalSign);
    return text;
}

/// Draws a label of the color scale, with its right edge at `right` and vertically centered at `y`.
void drawLabel(auto& image, const std::string& text, int right, int y)
{
    const TextBlock block({text}, burnSizes(image.width, image.height).textPx, TextAlign::Right);
    drawText(image, block, right - block.mask.width, y - block.mask.height / 2);
}

void drawTexts(auto& image, const CornerTexts& texts, const BurnSizes& sizes)
{
    const int margin = sizes.marginPx;
    enum class Edge { Top, Bottom };
    const auto draw = [&](const std::vector<std::string>& lines, TextAlign align, Edge edge) {
        const TextBlock block(lines, sizes.textPx, align);
        const int left = align == TextAlign::Left ? margin : image.width - margin - block.mask.width;
        drawText(image, block, left, edge == Edge::Bottom ? image.height - margin - block.mask.height : margin);
    };
    draw(texts.topLeft, TextAlign::Left, Edge::Top);
    draw(texts.topRight, TextAlign::Right, Edge::Top);
    draw(texts.bottomLeft, TextAlign::Left, Edge::Bottom);
    draw(texts.bottomRight, TextAlign::Right, Edge::Bottom);
}

void drawLabelAt(auto& image, const std::string& text, const Eigen::Vector2d& at, const BurnSizes& sizes)
{
    const TextBlock block({text}, sizes.textPx, TextAlign::Left);
    const auto inside = [](double wanted, int most) {
        return static_cast<int>(std::lround(std::clamp(wanted, 4.0, std::max(4.0, most - 4.0))));
    };
    drawText(image, block, inside(at.x(), image.width - block.mask.width),
             inside(at.y(), image.height - block.mask.height));
}

void drawVerdict(auto& image, const std::string& text, const BurnSizes& sizes)
{
    TextBlock block({text}, 2 * sizes.textPx, TextAlign::Left);
    block.tone = palette(ThemeMode::Dark).attention;
    drawText(image, block, std::max(4, (image.width - block.mask.width) / 2),
             sizes.marginPx + 6 * sizes.textPx);   // starts below the corner text
}

void drawScale(auto& image, const BurnScale& scale, const BurnSizes& sizes)
{
    const int barWidth = sizes.textPx;
    const int barHeight = std::max(8 * sizes.textPx, image.height / 6);
    const int capHeight = std::max(4, sizes.textPx * 2 / 3);
    const Rect bar{image.width - sizes.marginPx - barWidth, (image.height - barHeight) / 2, barWidth, barHeight};
    for (int y = 0; y < bar.height; ++y) {
        const double fraction = 1.0 - (y + 0.5) / bar.height;
        fill(image, {bar.left, bar.top + y, bar.width, 1}, residualColor(fraction), 1.0);
    }
    fill(image, {bar.left, bar.top - capHeight - 2, bar.width, capHeight}, residualColorAboveScale(), 1.0);

    const bool inMm = scale.maximumMm > 0.0;
    const double maximum = inMm ? scale.maximumMm : scale.maximumPx;
    const int decimals = residualScaleDecimals(maximum);
    const int right = bar.left - sizes.textPx / 2;
    const std::string unit = inMm ? "mm" : "px";
    drawLabel(image, scale.heading.empty() ? unit : scale.heading, right, bar.top - 5 * sizes.textPx / 2);
    drawLabel(image, "> " + formatted(maximum, decimals, scale.decimalSign), right, bar.top - capHeight / 2 - 2);
    drawLabel(image, formatted(0.5 * maximum, decimals, scale.decimalSign), right, bar.top + bar.height / 2);
    drawLabel(image, "0", right, bar.top + bar.height - sizes.textPx / 2);
}

}   // namespace

void burnTexts(core::ColorImage& image, const CornerTexts& texts, const BurnSizes& sizes)
{
    drawTexts(image, texts, sizes);
}

void burnTexts(VectorImage& image, const CornerTexts& texts, const BurnSizes& sizes)
{
    drawTexts(image, texts, sizes);
}

void burnLabel(core::ColorImage& image, const std::string& text, const Eigen::Vector2d& at, const BurnSizes& sizes)
{
    drawLabelAt(image, text, at, sizes);
}

void burnLabel(VectorImage& image, const std::string& text, const Eigen::Vector2d& at, const BurnSizes& sizes)
{
    drawLabelAt(image, text, at, sizes);
}

void burnVerdict(core::ColorImage& image, const std::string& text, const BurnSizes& sizes)
{
    drawVerdict(image, text, sizes);
}

void burnVerdict(VectorImage& image, const std::string& text, const BurnSizes& sizes)
{
    drawVerdict(image, text, sizes);
}

Eigen::Vector2d burnedSize(const std::string& text, const BurnSizes& sizes)
{
    const core::Mask2d mask = text.empty() ? core::Mask2d() : textMask({text}, sizes.textPx, TextAlign::Left);
    return {1.0 * mask.width, 1.0 * mask.height};
}

void burnScale(core::ColorImage& image, const BurnScale& scale, const BurnSizes& sizes)
{
    drawScale(image, scale, sizes);
}

void burnScale(VectorImage& image, const BurnScale& scale, const BurnSizes& sizes)
{
    drawScale(image, scale, sizes);
}

}   // namespace angiopose::ui
