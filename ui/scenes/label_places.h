#pragma once

#include "ui/scenes/view_rect.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::ui {

/// Label to place next to an anchor; all lengths in image px, y down.
struct LabelRequest {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();   ///< position of the anchor
    Eigen::Vector2d size = Eigen::Vector2d::Zero();   ///< size of the label; zero if there is no label
    double gapPx = 8.0;   ///< gap between anchor and label
};

/// Image bounds and obstacles for placing labels.
struct LabelObstacles {
    double width = 0.0;   ///< image size; labels stay inside
    double height = 0.0;
    std::vector<ViewRect> occupied;   ///< areas of other text
    std::vector<Eigen::Vector2d> avoided;   ///< vessel points, to be covered only if unavoidable
};

/// Returns the upper left corner of each label, next to its anchor: at the lower right if that is free, otherwise where
/// the label covers no other text and as few vessel points as possible.
std::vector<Eigen::Vector2d> placeLabels(const std::vector<LabelRequest>& labels, const LabelObstacles& obstacles);

}   // namespace angiopose::ui
