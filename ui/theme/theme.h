#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace angiopose::ui {

/// An sRGB colour, used by Qt and VTK alike.
struct Color {
    std::uint8_t red = 0, green = 0, blue = 0;

    bool operator==(const Color&) const = default;
    std::string hex() const;
    std::array<double, 3> unit() const { return {red / 255.0, green / 255.0, blue / 255.0}; }   ///< as VTK wants it
};

/// Every tone of the window; the only place with a colour value, so that Qt and VTK agree and a theme is one table.
/// Black around the image, neutral greys elsewhere, nothing pure white: the image is what is looked at.
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

/// How vessels and residuals are coloured. Every scheme can be read with any colour vision; the last by brightness
/// alone.
enum class ColorScheme { BlueAmber, BlueRed, Brightness };

/// The scheme of the whole program; workers that draw pictures ask too.
ColorScheme colorScheme();
void setColorScheme(ColorScheme scheme);

struct BranchColors {
    Color plain, auxiliary, selected;
};

/// Of a scan that is looked through: contrast-filled vessels as they are known from atlases, bone, all that is softer.
struct ScanColors {
    Color vessels, bone, soft;
};
ScanColors scanColors();

/// `tones` are those of the ground the branches lie on.
BranchColors branchColors(const Palette& tones);

/// The scheme's residual ramp, `fraction` 0…1: by default from accent blue over green-grey to amber.
Color residualColor(double fraction);

/// For residuals that lie above the end of the scale.
Color residualColorAboveScale();

/// Tells the labels of a label image apart, by their places in the list; on black and on panels alike. Far places
/// share colours.
Color labelColor(std::size_t place);

/// Style sheet of the whole application for a palette.
std::string styleSheet(const Palette& palette);

}   // namespace angiopose::ui