#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace angiopose::ui {

/// sRGB color for both Qt and VTK.
struct Color {
    std::uint8_t red = 0, green = 0, blue = 0;

    bool operator==(const Color&) const = default;
    std::string hex() const;
    std::array<double, 3> unit() const { return {red / 255.0, green / 255.0, blue / 255.0}; }   ///< 0…1, for VTK
};

/// All colors of the window, defined only here, which keeps Qt and VTK consistent and makes a theme a single table.
/// Black around the image, neutral grays elsewhere, no pure white: the image is the focus.
struct Palette {
    Color title, window, panel, field, line;
    Color textStrong, text, label, hint;
    Color accent;   ///< interactive or selected
    Color attention;   ///< needs attention
    Color fine;
    Color error;   ///< blocking errors only
    Color canvas;   ///< background of images
};

enum class ThemeMode { Dark, Light };

const Palette& palette(ThemeMode mode);

/// Mixes in sRGB: `a` for `shareOfB` 0, `b` for 1.
Color mixed(const Color& a, const Color& b, double shareOfB);

/// Color scheme of vessels and residuals. Every scheme is safe for color-blind users; the last uses brightness only.
enum class ColorScheme { BlueAmber, BlueRed, Brightness };

/// Color scheme of the whole program; also called by background renderers.
ColorScheme colorScheme();
void setColorScheme(ColorScheme scheme);

struct BranchColors {
    Color plain, auxiliary, selected;
};

/// Colors for volume rendering of a scan: contrast-enhanced vessels as in anatomical atlases, bone, and soft tissue.
struct ScanColors {
    Color vessels, bone, soft;
};
ScanColors scanColors();

/// `tones` belong to the background of the branches.
BranchColors branchColors(const Palette& tones);

/// Residual color for `fraction` 0…1 in the current scheme: by default from accent blue over green-gray to amber.
Color residualColor(double fraction);

/// Color of residuals above the end of the scale.
Color residualColorAboveScale();

/// Color of a label by its position in the list, distinguishable on black and on panels. Colors repeat for distant
/// positions.
Color labelColor(std::size_t place);

/// Returns the style sheet of the whole application for a palette.
std::string styleSheet(const Palette& palette);

}   // namespace angiopose::ui