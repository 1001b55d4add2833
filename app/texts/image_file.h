#pragma once

#include "app/texts/overlay_image.h"
#include "app/texts/svg_picture.h"

namespace angiopose::app {

/// Content of an exported image: vessels over the image, the image alone as displayed, or its 16-bit gray values.
enum class ImageFileContent { Overlay, Frame, Frame16 };

struct ImageFileOptions {
    ImageFileContent content = ImageFileContent::Overlay;
    double dotsPerInch = 0.0;   ///< print resolution; 0 if not stored in the file
};

/// Draws the exported image as vector graphics.
core::Result<ui::VectorImage> imageVectors(const core::Case& session, const core::Centerline2d& target,
                                           const OverlayImageOptions& options, const ImageFileOptions& file);

/// Returns the metadata for an SVG file.
SvgMetadata svgMetadata(const core::Case& session, const ImageFileOptions& file);

/// Writes a PNG or SVG file, depending on the extension, with the provenance of the image. 16-bit export requires PNG
/// and writes the shown frame at its native size, without text.
core::Status writeImageFile(const core::Case& session, const core::Centerline2d& target,
                            const OverlayImageOptions& options, const ImageFileOptions& file, const std::string& path);

}   // namespace angiopose::app
