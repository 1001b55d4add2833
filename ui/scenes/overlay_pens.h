#pragma once

#include "ui/scenes/branch_style.h"

#include <array>

/// Widths and opacities of the overlay's layers, the same for every renderer; widths are in line widths unless noted.
namespace angiopose::ui {

inline constexpr double edgeWidth = 0.7;   ///< outline of a vessel
inline constexpr double haloWidth = 1.1;   ///< extra width of the dark halo around a line
inline constexpr double haloOpacity = 0.65;
inline constexpr double haloFadePx = 1.5;
inline constexpr double glowWidth = 3.0;   ///< in branch widths, as is `glowFade`
inline constexpr double glowFade = 4.0;
inline constexpr double insideOpacity = 0.32;   ///< interior of tubes
inline constexpr double endDotRadius = 1.15;   ///< in branch widths
inline constexpr std::array<double, 2> branchDashes{3.5, 3.0};   ///< dash and gap
inline constexpr double tracedWidth = 0.85;
inline constexpr std::array<double, 2> tracedDots{0.1, 2.6};   ///< dash and gap, in widths of the traced curve
inline constexpr double tracedShadePx = 1.5;   ///< dark border around the dots: extra width and fade
inline constexpr double tracedShadeOpacity = 0.6;

constexpr double glowOpacity(Glow glow)
{
    return glow == Glow::Strong ? 0.55 : 0.3;
}

}   // namespace angiopose::ui
