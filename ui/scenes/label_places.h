#pragma once

#include "ui/scenes/view_rect.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::ui {

/// Label to place beside an anchor; all lengths in image px, v down.
struct WantedLabel {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();   ///< anchor
    Eigen::Vector2d size = Eigen::Vector2d::Zero();   ///< size of the label; zero: no label
    double gapPx = 8.0;   ///< distance from the anchor
};

/// Bounds and obstacles for labels.
struct LabelGround {
    double width = 0.0;   ///< image size; labels stay inside
    double height = 0.0;
    std::vector<ViewRect> taken;   ///< other texts
    std::vector<Eigen::Vector2d> avoided;   ///< vessel points
};

/// Returns upper left corners in the order of the labels: beside the anchors, below right if free, otherwise where they
/// cover no label or text and as few vessel points as possible.
std::vector<Eigen::Vector2d> labelPlaces(const std::vector<WantedLabel>& labels, const LabelGround& ground);

}   // namespace angiopose::ui
