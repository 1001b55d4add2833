#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace ui {

/// An sRGB colour, used by Qt and VTK alike.
struct Color {
    std::uint8_t red = 0, green = 0, blue = 0;

    bool operator==(const Color&) const = default;
    std::string hex() const;
    std::array<double, 3> unit() const { return {red / 255.0, green / 255.0, blue / 255.0}; }   ///< as VTK wants it
};

/// Every tone of the window (WINDOW.md); the only place with a colour value.
struct Palette {
    Color title, window, panel, field, line;
    Color textStrong, text, label, hint;
    Color accent;   ///< what can be acted on or is selected
    Color attention;   ///< look here
    Color fine;
    Color error;   ///< only what stops work
    Color canvas;   ///< around images
};

enum class ThemeMode { Dark, Light };

const Palette& palette(ThemeMode mode);

/// `a` where `shareOfB` is 0, `b` where it is 1, mixed in sRGB.
Color mixed(const Color& a, const Color& b, double shareOfB);

/// Residual ramp from accent blue over green-grey to amber, safe for colour-vision deficiency; `fraction` 0…1.
Color residualColor(double fraction);

/// For residuals that lie above the end of the scale.
Color residualColorAboveScale();

/// Style sheet of the whole application for a palette.
std::string styleSheet(const Palette& palette);

}   // namespace ui
