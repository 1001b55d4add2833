#pragma once

#include "app/texts/case_texts.h"
#include "app/texts/deformed_vessels.h"
#include "core/case/case.h"
#include "core/imaging/display_range.h"
#include "core/imaging/image2d.h"
#include "core/support/result.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/scenes/vector_image.h"

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace angiopose::app {

/// Coloring of the vessels. Residuals: distances of the vessels as drawn from the target. Motion: distances of the
/// deformed from the rigid vessels, if a deformation is known. Branches: a color per branch.
enum class OverlayColoring { Residuals, Motion, Branches };

struct OverlayImageOptions {
    int widthPx = 0;   ///< if 0, twice the image width; the height follows from the aspect ratio of the image
    OverlayColoring coloring = OverlayColoring::Residuals;
    Identity identity = Identity::Hidden;
    ui::CornerTexts (*texts)(const CornerLines&) =
        englishTexts;   ///< converts the corner text to the language of the image; the window uses windowTexts
    ui::OverlayMode vessels = ui::OverlayMode::Centerline;
    std::optional<core::DisplayRange> range = std::nullopt;   ///< if not set, determined automatically from the frame
    ui::DepthCue depthCue = ui::DepthCue::None;
    VesselShape shape = VesselShape::Deformed;   ///< applies if the pose has a deformation; a caption states the shape
    ui::Cutout cutout = {};   ///< region of the swipe or lens, in which vessels are not drawn, image px
    /// Whether to add a second image on the left with the vessels at the initial pose.
    bool isInitialPoseShown = false;
    std::optional<core::Message> words = std::nullopt;   ///< caption at the bottom left, for one of several images
    /// Computes the DRR for a pose, which replaces the vessel lines; if not set, the lines are drawn.
    std::function<core::Result<core::ImageF>(const core::RigidTransform& cameraFromPatient)> drr = nullptr;
};

/// Draws the overlay image as used in reports: angiogram, projected tree at the case's pose, residual colors relative
/// to `target` with their scale, corner text and the notice. Requires no display.
core::Result<core::ColorImage> drawOverlay(const core::Case& session, const core::Centerline2d& target,
                                           const OverlayImageOptions& options = {});

/// Draws the same image as vector graphics.
core::Result<ui::VectorImage> drawOverlayVectors(const core::Case& session, const core::Centerline2d& target,
                                                 const OverlayImageOptions& options = {});

/// Draws a small image without text: the tree at the case's pose over the image, colored by residuals from any target.
core::Result<core::ColorImage> drawThumbnail(const core::Case& session, int widthPx,
                                             const core::Centerline2d* target = nullptr);

/// Returns the provenance of the image (inputs with hashes, version, method, pose, notice) for the PNG's text chunks.
std::map<std::string, std::string> provenanceTexts(const core::Case& session);

/// Returns the residual, px, at which the color scale ends: 2 mm at the vessels.
double residualScaleMaximumPx(const core::ProjectionCamera& camera, double depthMm);

}   // namespace angiopose::app
