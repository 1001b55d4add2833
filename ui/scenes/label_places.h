#pragma once

#include "ui/scenes/view_rect.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::ui {

/// A label that wants to stand beside a place; all in px of a picture, v down.
struct WantedLabel {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();   ///< the place
    Eigen::Vector2d size = Eigen::Vector2d::Zero();   ///< of the label; zero: there is none
    double gapPx = 8.0;   ///< from the place
};

/// What labels keep clear of.
struct LabelGround {
    double width = 0.0;   ///< of the picture; labels stay inside
    double height = 0.0;
    std::vector<ViewRect> taken;   ///< other texts
    std::vector<Eigen::Vector2d> avoided;   ///< points of vessels
};

/// Upper left corners, in the order of the labels: beside their places, below and right if that is free, else where
/// they cover neither each other nor other texts, and the least of the vessels.
std::vector<Eigen::Vector2d> labelPlaces(const std::vector<WantedLabel>& labels, const LabelGround& ground);

}   // namespace angiopose::ui
