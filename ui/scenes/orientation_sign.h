#pragma once

#include "ui/scenes/orbit.h"
#include "ui/scenes/stroke_mesh.h"
#include "ui/theme/theme.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::ui {

/// Three arms from a common point in the lower right corner, towards the patient's left, back and head in the current
/// view.
struct OrientationSign {
    ScreenFromPatient toScreen;
    int widthPx = 0;   ///< width of the view, device px
    double pixelScale = 1.0;   ///< device px per px

    Eigen::Vector2d center() const;   ///< device px from the bottom left
};

/// Letter of the sign (L, P, H) and its center, device px from the bottom left.
struct OrientationLetter {
    char letter = ' ';
    Eigen::Vector2d at;
    bool pointsToViewer = false;
};

void addOrientationSign(StrokeMesh& mesh, const OrientationSign& sign, const Palette& tones);

/// Returns the letters at the ends of the arms; omits a letter if its arm points along the line of sight or it would
/// cover another letter.
std::vector<OrientationLetter> lettersOf(const OrientationSign& sign);

}   // namespace angiopose::ui
