#pragma once

#include "app/texts/overlay_picture.h"
#include "app/texts/svg_picture.h"

namespace angiopose::app {

/// What an exported picture shows: vessels over the image, the image alone as it is seen, or its grey values in 16 bit.
enum class PictureContent { Overlay, Frame, Frame16 };

struct PictureFile {
    PictureContent content = PictureContent::Overlay;
    double dotsPerInch = 0.0;   ///< 0: none is told
};

/// The picture as vectors.
core::Result<ui::VectorPicture> pictureVectors(const core::Case& session, const core::Centerline2d& target,
                                               const OverlayPictureOptions& options, const PictureFile& file);

/// What files of it say about themselves.
SvgFacts factsOf(const core::Case& session, const PictureFile& file);

/// Writes PNG or SVG by the end of the path, with where the picture comes from. 16 bit are PNG alone, the shown frame
/// at its own size without texts.
core::Status writePictureFile(const core::Case& session, const core::Centerline2d& target,
                              const OverlayPictureOptions& options, const PictureFile& file, const std::string& path);

}   // namespace angiopose::app
