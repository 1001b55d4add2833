#pragma once

#include "ui/scenes/overlay_content.h"
#include "ui/theme/theme.h"

#include <optional>
#include <vector>

namespace angiopose::ui {

/// Color of every point of one branch: its own, by residual, or by depth.
class PointTones {
public:
    PointTones(const OverlayContent& content, int branchId, const Color& plain);

    Color operator()(const ProjectedPoint& point) const;

    /// Color of the tree point `index` without depth cueing.
    Color flat(std::size_t index) const;

private:
    Color plain_;
    std::optional<DepthRange> depth_;   ///< used instead of residuals
    const std::vector<double>* residualPx_ = nullptr;
    double maximumPx_ = 0.0;
};

}   // namespace angiopose::ui
