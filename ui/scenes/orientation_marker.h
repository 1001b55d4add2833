#pragma once

#include "ui/scenes/orbit.h"
#include "ui/scenes/stroke_mesh.h"
#include "ui/theme/theme.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::ui {

/// Orientation marker in the lower right corner: three arms from a common point toward left, posterior and superior.
struct OrientationMarker {
    ScreenFromPatient toScreen;
    int widthPx = 0;   ///< width of the view, device px
    double pixelScale = 1.0;   ///< device px per logical px

    Eigen::Vector2d center() const;   ///< device px from the bottom left corner
};

/// Letter of the orientation marker (L, P, H) and its center, device px from the bottom left corner.
struct OrientationLetter {
    char letter = ' ';
    Eigen::Vector2d at;
    bool pointsToViewer = false;
};

void addOrientationMarker(StrokeMesh& mesh, const OrientationMarker& sign, const Palette& colors);

/// Returns the letters at the tips of the arms, except where an arm points along the viewing direction or a letter
/// would cover another.
std::vector<OrientationLetter> markerLetters(const OrientationMarker& sign);

}   // namespace angiopose::ui
