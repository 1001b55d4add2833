#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Draws a straight piece of a vessel as X-rays show it, by the length of the chords through it (px); where pieces
/// overlap the longer chord stays.
void drawTube(ImageF& image, const Eigen::Vector2d& fromPx, const Eigen::Vector2d& toPx, double radiusPx);

/// The traced vessels as an image, each as wide as it was traced, 1.5 px where its width is unknown.
ImageF pictureOf(const TargetSamples& target, int width, int height);

/// The projected tree as an image of `camera`, each vessel as wide as it is, 1 mm where its width is unknown.
ImageF pictureOf(const TreeSamples& tree, const ProjectionCamera& camera, const RigidTransform& cameraFromPatient);

/// The camera of `halved` images.
ProjectionCamera halved(const ProjectionCamera& camera);

}   // namespace angiopose::core