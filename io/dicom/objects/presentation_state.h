#pragma once

#include "core/imaging/display_range.h"
#include "io/dicom/objects/derived_object.h"
#include "io/dicom/objects/lab_color.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Words beside a place on the image.
struct StateText {
    std::string words;
    Eigen::Vector2d at;   ///< px
};

/// Lines and words of one colour that are shown and hidden together.
struct StateLayer {
    std::string name;   ///< capitals, digits, blanks and `_`, at most 16
    std::string description;
    RgbColor color{255, 255, 0};
    std::vector<std::vector<Eigen::Vector2d>> lines;   ///< px, (0, 0) is the centre of the first pixel
    std::vector<StateText> texts;
};

/// How an image is to be shown.
struct ShownState {
    std::vector<StateLayer> layers;
    int frame = 0;   ///< that the lines lie on
    std::optional<core::DisplayRange> range;   ///< of the values after the rescaling; none: as the image says itself
    std::string description;
};

/// Grayscale Softcopy Presentation State (PS3.3 A.33.1): the lines as vectors on the image, which stays as it is. Fails
/// where the image cannot be referred to, or there is no line.
core::Result<std::string> presentationState(const ShownState& shown, const SourceImage& source,
                                            const ObjectOrigin& origin);

}   // namespace angiopose::io
