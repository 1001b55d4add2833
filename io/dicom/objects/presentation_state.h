#pragma once

#include "core/imaging/display_range.h"
#include "io/dicom/objects/derived_object.h"
#include "io/dicom/objects/lab_color.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Text annotation at a position in the image.
struct GraphicText {
    std::string words;
    Eigen::Vector2d at;   ///< position, px
};

/// Lines and text of one color that viewers show and hide together.
struct GraphicLayer {
    std::string name;   ///< at most 16 upper-case letters, digits, spaces and `_`
    std::string description;
    RgbColor color{255, 255, 0};
    std::vector<std::vector<Eigen::Vector2d>> lines;   ///< polylines, px; (0, 0) is the center of the first pixel
    std::vector<GraphicText> texts;
};

/// Content of a presentation state.
struct PresentationContent {
    std::vector<GraphicLayer> layers;
    int frame = 0;   ///< frame to which the lines belong
    std::optional<core::DisplayRange> range;   ///< range of rescaled values; if not set, that of the image header
    std::string description;
};

/// Returns a Grayscale Softcopy Presentation State (PS3.3 A.33.1): the lines as vector graphics on the unchanged image.
/// Fails if the image cannot be referenced or there are no lines.
core::Result<std::string> encodePresentationState(const PresentationContent& shown, const SourceImage& source,
                                                  const ObjectOrigin& origin);

}   // namespace angiopose::io
