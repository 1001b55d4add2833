#pragma once

#include "ui/scenes/branch_style.h"

#include <array>

/// Widths and opacities of the overlay's layers, the same for every renderer; widths in line widths unless noted.
namespace angiopose::ui {

inline constexpr double edgeWidth = 0.7;   ///< outlines
inline constexpr double haloWidth = 1.1;   ///< extends beyond the line
inline constexpr double haloOpacity = 0.65;
inline constexpr double haloFadePx = 1.5;
inline constexpr double glowWidth = 3.0;   ///< width and fade, in widths of the branch
inline constexpr double glowFade = 4.0;
inline constexpr double insideOpacity = 0.32;   ///< tubes
inline constexpr double endDotRadius = 1.15;   ///< in widths of the branch
inline constexpr std::array<double, 2> branchDashes{3.5, 3.0};   ///< dash, gap
inline constexpr double tracedWidth = 0.85;
inline constexpr std::array<double, 2> tracedDots{0.1, 2.6};   ///< dash, gap; in widths of the traced curve
inline constexpr double tracedShadePx = 1.5;   ///< width beyond the dots, and fade
inline constexpr double tracedShadeOpacity = 0.6;

constexpr double glowOpacity(Glow glow)
{
    return glow == Glow::Strong ? 0.55 : 0.3;
}

}   // namespace angiopose::ui
