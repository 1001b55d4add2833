#pragma once

#include "core/imaging/display_range.h"
#include "io/dicom/objects/derived_object.h"
#include "io/dicom/objects/lab_color.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// A text at a position on the image.
struct StateText {
    std::string words;
    Eigen::Vector2d at;   ///< px
};

/// Lines and texts of one color that are shown and hidden together.
struct StateLayer {
    std::string name;   ///< upper-case letters, digits, spaces and `_`, at most 16
    std::string description;
    RgbColor color{255, 255, 0};
    std::vector<std::vector<Eigen::Vector2d>> lines;   ///< px; (0, 0) is the center of the first pixel
    std::vector<StateText> texts;
};

/// The presentation of an image.
struct ShownState {
    std::vector<StateLayer> layers;
    int frame = 0;   ///< frame of the lines
    std::optional<core::DisplayRange> range;   ///< of the rescaled values; none: as the image's header specifies
    std::string description;
};

/// Grayscale Softcopy Presentation State (PS3.3 A.33.1): the lines as vector graphics on the unchanged image. Fails if
/// the image cannot be referenced or there are no lines.
core::Result<std::string> presentationState(const ShownState& shown, const SourceImage& source,
                                            const ObjectOrigin& origin);

}   // namespace angiopose::io
