#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Draws a straight vessel piece as in an X-ray image, by the length of the chords through it (px); where pieces
/// overlap, keeps the longer chord.
void drawTube(ImageF& image, const Eigen::Vector2d& fromPx, const Eigen::Vector2d& toPx, double radiusPx);

/// Renders the traced vessels at their traced widths, 1.5 px where the width is unknown.
ImageF pictureOf(const TargetSamples& target, int width, int height);

/// Renders the tree projected by `camera`, each vessel at its width, 1 mm where it is unknown.
ImageF pictureOf(const TreeSamples& tree, const ProjectionCamera& camera, const RigidTransform& cameraFromPatient);

/// Camera of the images that `halved` returns.
ProjectionCamera halved(const ProjectionCamera& camera);

}   // namespace angiopose::core