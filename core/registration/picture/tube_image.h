#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Draws a straight vessel segment as in an X-ray image, with the chord length through the tube as intensity (px);
/// where segments overlap, the longer chord is kept.
void drawTube(ImageF& image, const Eigen::Vector2d& fromPx, const Eigen::Vector2d& toPx, double radiusPx);

/// Returns an image of the traced vessels at their traced radii, or 1.5 px if unknown.
ImageF renderTubes(const TargetSamples& target, int width, int height);

/// Returns an image of the tree projected by `camera`, with each vessel at its radius, or 1 mm if unknown.
ImageF renderTubes(const TreeSamples& tree, const ProjectionCamera& camera, const RigidTransform& cameraFromPatient);

/// Returns the camera for images at half the resolution.
ProjectionCamera halfSizeCamera(const ProjectionCamera& camera);

}   // namespace angiopose::core
