#pragma once

#include "ui/scenes/branch_style.h"

#include <array>

/// Widths and opacities of the overlay's layers, the same for every renderer; widths in line widths unless told.
namespace angiopose::ui {

inline constexpr double edgeWidth = 0.7;   ///< of outlines
inline constexpr double haloWidth = 1.1;   ///< beyond the line
inline constexpr double haloOpacity = 0.65;
inline constexpr double haloFadePx = 1.5;
inline constexpr double glowWidth = 3.0;   ///< of the branch's own width, as is its fade
inline constexpr double glowFade = 4.0;
inline constexpr double insideOpacity = 0.32;   ///< of tubes
inline constexpr double endDotRadius = 1.15;   ///< of the branch's own width
inline constexpr std::array<double, 2> branchDashes{3.5, 3.0};   ///< drawn, gap
inline constexpr double tracedWidth = 0.85;
inline constexpr std::array<double, 2> tracedDots{0.1, 2.6};   ///< drawn, gap; of the traced curve's own width
inline constexpr double tracedShadePx = 1.5;   ///< beyond the dots; its fade too
inline constexpr double tracedShadeOpacity = 0.6;

constexpr double glowOpacity(Glow glow)
{
    return glow == Glow::Strong ? 0.55 : 0.3;
}

}   // namespace angiopose::ui
