#pragma once

#include "app/texts/overlay_picture.h"
#include "app/texts/svg_picture.h"

namespace angiopose::app {

/// Content of an exported image: vessels over the image, the image alone as displayed, or its gray values with 16 bits.
enum class PictureContent { Overlay, Frame, Frame16 };

struct PictureFile {
    PictureContent content = PictureContent::Overlay;
    double dotsPerInch = 0.0;   ///< 0 if not stored in the file
};

/// Draws the exported image as vector graphics.
core::Result<ui::VectorPicture> pictureVectors(const core::Case& session, const core::Centerline2d& target,
                                               const OverlayPictureOptions& options, const PictureFile& file);

/// Returns the metadata for an SVG file.
SvgFacts factsOf(const core::Case& session, const PictureFile& file);

/// Writes a PNG or SVG file, depending on the extension, with the provenance of the image. 16-bit export is limited to
/// PNG: the shown frame at its native size, without texts.
core::Status writePictureFile(const core::Case& session, const core::Centerline2d& target,
                              const OverlayPictureOptions& options, const PictureFile& file, const std::string& path);

}   // namespace angiopose::app
