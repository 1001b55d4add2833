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

/// Vessel coloring. Residuals: of the vessels as drawn. Motion: distance of the deformed vessels from the rigid ones,
/// if a deformation is known.
enum class OverlayColoring { Residuals, Motion, Branches };

/// Options of an exported overlay.
struct OverlayPictureOptions {
    int widthPx = 0;   ///< 0: twice the image width; the height follows from the aspect ratio of the image
    OverlayColoring coloring = OverlayColoring::Residuals;
    Identity identity = Identity::Hidden;
    ui::CornerTexts (*texts)(const CornerLines&) =
        englishTexts;   ///< language of the burned-in texts; the window uses windowTexts
    ui::OverlayMode vessels = ui::OverlayMode::Centerline;
    std::optional<core::DisplayRange> range = std::nullopt;   ///< not set: automatic for the frame
    ui::DepthCue depthCue = ui::DepthCue::None;
    VesselShape shape = VesselShape::Deformed;   ///< if the pose has a deformation; a caption names the shape
    ui::Cutout cutout = {};   ///< swipe or lens region without vessels, image px
    /// Adds a second image on the left with the vessels at the initial pose (before and after).
    bool isStartBeside = false;
    std::optional<core::Message> words = std::nullopt;   ///< caption at the bottom left, for one of several images
    /// Computes a DRR from a pose, shown instead of the vessel lines; not set: lines.
    std::function<core::Result<core::ImageF>(const core::RigidTransform& cameraFromPatient)> drr = nullptr;
};

/// Overlay image as used in reports: angiogram, projected tree at the case's pose, colors (of residuals against
/// `target`) with their scale, corner texts and the notice. Needs no display.
core::Result<core::ColorImage> drawOverlay(const core::Case& session, const core::Centerline2d& target,
                                           const OverlayPictureOptions& options = {});

/// The same image as vectors.
core::Result<ui::VectorPicture> drawOverlayVectors(const core::Case& session, const core::Centerline2d& target,
                                                   const OverlayPictureOptions& options = {});

/// Small version without texts: the tree at the case's pose over the image, colored by residuals if a target is given.
core::Result<core::ColorImage> drawThumbnail(const core::Case& session, int widthPx,
                                             const core::Centerline2d* target = nullptr);

/// Provenance of the image (inputs with hashes, version, method, pose, notice), for the PNG's text chunks.
std::map<std::string, std::string> provenanceTexts(const core::Case& session);

/// Residual, in px, at which the color ramp ends: 2 mm at the vessels.
double residualScaleMaximumPx(const core::ProjectionCamera& camera, double depthMm);

}   // namespace angiopose::app