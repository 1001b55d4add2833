#pragma once

#include "app/texts/case_texts.h"
#include "app/texts/deformed_vessels.h"
#include "core/case/case.h"
#include "core/imaging/display_range.h"
#include "core/imaging/image2d.h"
#include "core/support/result.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/scenes/vector_picture.h"

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace angiopose::app {

/// Residuals of the vessels as they are drawn; Motion: how far the bent ones lie from the rigid ones, where they are
/// known.
enum class OverlayColoring { Residuals, Motion, Branches };

/// How an exported overlay looks.
struct OverlayPictureOptions {
    int widthPx = 0;   ///< 0: twice the image; the height follows from the image
    OverlayColoring coloring = OverlayColoring::Residuals;
    Identity identity = Identity::Hidden;
    ui::CornerTexts (*texts)(const CornerLines&) = englishTexts;   ///< burned in; the window has windowTexts for them
    ui::OverlayMode vessels = ui::OverlayMode::Centerline;
    std::optional<core::DisplayRange> range = std::nullopt;   ///< not set: found from the frame
    ui::DepthCue depthCue = ui::DepthCue::None;
    VesselShape shape = VesselShape::Deformed;   ///< where the pose has bent vessels; the picture says which they are
    ui::Cutout cutout = {};   ///< swipe or lens where the vessels step aside, image px
    /// Before and after: a second picture on the left with the vessels at the start pose.
    bool isStartBeside = false;
    std::optional<core::Message> words = std::nullopt;   ///< at the bottom left, of a picture among several
    /// Shows the vessels as a radiograph, which this makes from a pose, in place of their lines; not set: lines.
    std::function<core::Result<core::ImageF>(const core::RigidTransform& cameraFromPatient)> radiograph = nullptr;
};

/// The picture that reports carry: angiogram, projected tree at the case's pose, colours (of residuals against
/// `target`) with their scale, corner texts and the notice. Needs no display.
core::Result<core::ColorImage> drawOverlay(const core::Case& session, const core::Centerline2d& target,
                                           const OverlayPictureOptions& options = {});

/// The same as vectors.
core::Result<ui::VectorPicture> drawOverlayVectors(const core::Case& session, const core::Centerline2d& target,
                                                   const OverlayPictureOptions& options = {});

/// The same small, without texts: the tree at the case's pose over the image, in the colours of its residuals where a
/// target is given.
core::Result<core::ColorImage> drawThumbnail(const core::Case& session, int widthPx,
                                             const core::Centerline2d* target = nullptr);

/// Where the picture comes from (inputs with hashes, version, method, pose, notice), for the PNG's text chunks.
std::map<std::string, std::string> provenanceTexts(const core::Case& session);

/// The residual, in px, at which the colour ramp ends: 2 mm at the vessels.
double residualScaleMaximumPx(const core::ProjectionCamera& camera, double depthMm);

}   // namespace angiopose::app