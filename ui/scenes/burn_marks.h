#pragma once

#include "core/imaging/image2d.h"
#include "ui/scenes/burn_text.h"
#include "ui/scenes/image_mark.h"
#include "ui/scenes/view_rect.h"

namespace angiopose::ui {

/// Draws marks with their labels onto an exported image that shows `part` of the angiogram. Labels stay inside the
/// image and avoid each other, the corner text and the vessel points `avoided` (angiogram px).
void burnMarks(core::ColorImage& image, const std::vector<ImageMark>& marks, const ViewRect& part,
               const BurnSizes& sizes, const std::vector<Eigen::Vector2d>& avoided = {});

void burnMarks(VectorImage& image, const std::vector<ImageMark>& marks, const ViewRect& part, const BurnSizes& sizes,
               const std::vector<Eigen::Vector2d>& avoided = {});

}   // namespace angiopose::ui
