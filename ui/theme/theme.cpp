#include "ui/theme/theme.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>

namespace angiopose::ui {
namespace {

constexpr Palette dark{.title = {0x0f, 0x11, 0x14},
                       .window = {0x15, 0x18, 0x1c},
                       .panel = {0x1a, 0x1e, 0x23},
                       .field = {0x11, 0x14, 0x17},
                       .line = {0x26, 0x2c, 0x33},
                       .textStrong = {0xe8, 0xed, 0xf2},
                       .text = {0xc9, 0xd1, 0xda},
                       .label = {0x8a, 0x95, 0xa3},
                       .hint = {0x6d, 0x78, 0x84},
                       .accent = {0x4c, 0xc2, 0xff},
                       .attention = {0xe0, 0xa8, 0x4a},
                       .fine = {0x7b, 0xd8, 0x8f},
                       .error = {0xf0, 0x6a, 0x5f},
                       .canvas = {0x00, 0x00, 0x00}};

// Not an inverted dark theme: paper-gray panels, black image background, and signal colors dark enough for text.
constexpr Palette light{.title = {0xdb, 0xdf, 0xe4},
                        .window = {0xe6, 0xe9, 0xed},
                        .panel = {0xf0, 0xf2, 0xf4},
                        .field = {0xfa, 0xfb, 0xfb},
                        .line = {0xc8, 0xce, 0xd5},
                        .textStrong = {0x12, 0x17, 0x1c},
                        .text = {0x2a, 0x32, 0x3a},
                        .label = {0x52, 0x5d, 0x69},
                        .hint = {0x66, 0x71, 0x7d},
                        .accent = {0x0b, 0x6f, 0xb0},
                        .attention = {0x8f, 0x5a, 0x00},
                        .fine = {0x1c, 0x74, 0x38},
                        .error = {0xb4, 0x2a, 0x20},
                        .canvas = {0x00, 0x00, 0x00}};

/// Residual color ramp: start (good fit), middle and end of the scale, and the color above the scale.
struct Ramp {
    Color fits, middle, end, above;
};

constexpr Ramp blueAmber{dark.accent, {0x9d, 0xc2, 0xa6}, dark.attention, {0xe0, 0x78, 0x3c}};
constexpr Ramp blueRed{{0x3f, 0x8c, 0xff}, {0xf2, 0xf2, 0xf2}, {0xff, 0x5a, 0x46}, {0xff, 0x3a, 0xd0}};
constexpr Ramp brightness{{0x5c, 0x5c, 0x5c}, {0x98, 0x98, 0x98}, {0xd4, 0xd4, 0xd4}, {0xff, 0xff, 0xff}};

// No entry resembles the accent or attention color; neighboring entries differ in brightness and hue.
constexpr std::array<Color, 8> labelColors{{{0xe6, 0x6a, 0x5c},
                                            {0x5f, 0xc8, 0x8a},
                                            {0x9a, 0x7c, 0xe8},
                                            {0xe8, 0xd4, 0x6a},
                                            {0x4a, 0x86, 0xd8},
                                            {0xf0, 0x9c, 0xcc},
                                            {0xa8, 0x78, 0x4c},
                                            {0x86, 0xdc, 0xd8}}};

std::atomic<ColorScheme> activeScheme{ColorScheme::BlueAmber};

const Ramp& activeRamp()
{
    const ColorScheme scheme = activeScheme;
    return scheme == ColorScheme::BlueRed ? blueRed : scheme == ColorScheme::Brightness ? brightness : blueAmber;
}

}   // namespace

std::string Color::hex() const
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", red, green, blue);
    return text;
}

const Palette& palette(ThemeMode mode)
{
    return mode == ThemeMode::Dark ? dark : light;
}

Color mixed(const Color& a, const Color& b, double fractionOfB)
{
    const double share = std::clamp(fractionOfB, 0.0, 1.0);
    const auto mix = [share](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(std::lround((1.0 - share) * x + share * y));
    };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

ColorScheme colorScheme()
{
    return activeScheme;
}

void setColorScheme(ColorScheme scheme)
{
    activeScheme = scheme;
}

BranchColors branchColors(const Palette& colors)
{
    switch (colorScheme()) {
        case ColorScheme::BlueRed:
            return {mixed(colors.text, colors.label, 0.3), blueRed.fits, blueRed.end};
        case ColorScheme::Brightness:
            return {colors.label, colors.text, colors.textStrong};
        case ColorScheme::BlueAmber:
            break;
    }
    return {mixed(colors.text, colors.accent, 0.45), colors.accent, colors.accent};
}

Color residualColor(double fraction)
{
    const Ramp& ramp = activeRamp();
    const double f = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 1.0;
    return f < 0.5 ? mixed(ramp.fits, ramp.middle, 2.0 * f) : mixed(ramp.middle, ramp.end, 2.0 * f - 1.0);
}

Color labelColor(std::size_t index)
{
    const Color& own = labelColors[index % labelColors.size()];
    switch (index / labelColors.size() % 3) {   // uses lighter and darker variants before repeating colors
        case 0:
            return own;
        case 1:
            return mixed(own, dark.textStrong, 0.45);
        default:
            return mixed(own, dark.canvas, 0.2);
    }
}

ScanColors scanColors()
{
    return {{0xd8, 0x86, 0x72}, {0xd9, 0xd2, 0xc4}, {0xb0, 0xa2, 0x98}};
}

Color residualColorAboveScale()
{
    return activeRamp().above;
}

}   // namespace angiopose::ui
