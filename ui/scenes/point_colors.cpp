#include "ui/scenes/point_colors.h"

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

Color residualTone(double residualPx, double maximumPx)
{
    return residualPx > maximumPx ? residualColorAboveScale() : residualColor(residualPx / maximumPx);
}

/// Blends near points toward white and far points toward the background.
Color withDepth(const Color& color, double depthMm, const DepthRange& range)
{
    const Palette& colors = palette(ThemeMode::Dark);
    const double spanMm = std::max(1.0, range.farMm - range.nearMm);
    const double farness = std::clamp((depthMm - range.nearMm) / spanMm, 0.0, 1.0);
    return farness < 0.5 ? mixed(colors.textStrong, color, 0.3 + 1.4 * farness)
                         : mixed(color, colors.canvas, 1.5 * (farness - 0.5));
}

}   // namespace

PointColors::PointColors(const OverlayContent& content, int branchId, const Color& plain)
    : plain_(plain), depth_(content.depthCue == DepthCue::None ? std::nullopt : std::optional(content.depthRange))
{
    const auto it = content.residualPx.find(branchId);
    if (!depth_ && content.scaleMaximumPx > 0.0 && it != content.residualPx.end()) {
        residualPx_ = &it->second;
        maximumPx_ = content.scaleMaximumPx;
    }
}

Color PointColors::operator()(const ProjectedPoint& point) const
{
    return depth_ ? withDepth(plain_, point.depthMm, *depth_) : flat(point.index);
}

Color PointColors::flat(std::size_t index) const
{
    const bool isKnown = residualPx_ && index < residualPx_->size() && std::isfinite((*residualPx_)[index]);
    return isKnown ? residualTone((*residualPx_)[index], maximumPx_) : plain_;
}

}   // namespace angiopose::ui
