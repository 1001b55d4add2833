#pragma once

#include "core/imaging/image2d.h"
#include "ui/scenes/burn_text.h"
#include "ui/scenes/image_mark.h"
#include "ui/scenes/view_rect.h"

namespace angiopose::ui {

/// Draws marks with their labels onto a picture that shows `part` of the image. Labels stay inside the picture and keep
/// clear of each other, of the corners' texts, and of `avoided`: points of vessels in px of the image.
void burnMarks(core::ColorImage& picture, const std::vector<ImageMark>& marks, const ViewRect& part,
               const BurnSizes& sizes, const std::vector<Eigen::Vector2d>& avoided = {});

void burnMarks(VectorPicture& picture, const std::vector<ImageMark>& marks, const ViewRect& part,
               const BurnSizes& sizes, const std::vector<Eigen::Vector2d>& avoided = {});

}   // namespace angiopose::ui
