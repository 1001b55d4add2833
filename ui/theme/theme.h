#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace angiopose::ui {

/// sRGB color, convertible for Qt and VTK.
struct Color {
    std::uint8_t red = 0, green = 0, blue = 0;

    bool operator==(const Color&) const = default;
    std::string hex() const;
    std::array<double, 3> unit() const { return {red / 255.0, green / 255.0, blue / 255.0}; }   ///< 0…1, for VTK
};

/// All colors of the user interface, defined once to keep Qt and VTK consistent; a theme is one such table. Black
/// around the image, neutral grays elsewhere and the absence of pure white keep the focus on the image.
struct Palette {
    Color title, window, panel, field, line;
    Color textStrong, text, label, hint;
    Color accent;   ///< interactive or selected items
    Color attention;   ///< items that need attention
    Color fine;
    Color error;   ///< blocking errors only
    Color canvas;   ///< background of images
};

enum class ThemeMode { Dark, Light };

const Palette& palette(ThemeMode mode);

/// Mixes two colors in sRGB; `fractionOfB` is 0 for `a` and 1 for `b`.
Color mixed(const Color& a, const Color& b, double fractionOfB);

/// Color scheme of vessels and residuals. Every scheme is safe for color-blind users; the last uses brightness only.
enum class ColorScheme { BlueAmber, BlueRed, Brightness };

/// Returns the color scheme of the program. Background renderers may call it.
ColorScheme colorScheme();
void setColorScheme(ColorScheme scheme);

struct BranchColors {
    Color plain, auxiliary, selected;
};

/// Colors for volume rendering of a scan: contrast-enhanced vessels as in anatomical atlases, bone, and soft tissue.
struct ScanColors {
    Color vessels, bone, softTissue;
};
ScanColors scanColors();

/// Returns the colors of branches on a background whose palette is `colors`.
BranchColors branchColors(const Palette& colors);

/// Returns the residual color for `fraction` 0…1 in the current scheme: by default accent blue, green-gray, amber.
Color residualColor(double fraction);

/// Returns the color of residuals beyond the end of the scale.
Color residualColorAboveScale();

/// Returns the color of a label by its index in the list, distinguishable on black and on panels. Colors recur only at
/// distant indices.
Color labelColor(std::size_t index);

/// Returns the style sheet of the application for a palette.
std::string styleSheet(const Palette& palette);

}   // namespace angiopose::ui
