#pragma once

#include "ui/scenes/overlay_content.h"
#include "ui/theme/theme.h"

#include <optional>
#include <vector>

namespace angiopose::ui {

/// Determines the color of each point of a branch: the branch color, or a color by residual or by depth.
class PointColors {
public:
    PointColors(const OverlayContent& content, int branchId, const Color& plain);

    Color operator()(const ProjectedPoint& point) const;

    /// Returns the color of the tree point `index` without depth cueing.
    Color flat(std::size_t index) const;

private:
    Color plain_;
    std::optional<DepthRange> depth_;   ///< if set, points are colored by depth instead of residual
    const std::vector<double>* residualPx_ = nullptr;
    double maximumPx_ = 0.0;
};

}   // namespace angiopose::ui
