#pragma once

#include "ui/scenes/orbit.h"
#include "ui/scenes/stroke_mesh.h"
#include "ui/theme/theme.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::ui {

/// Three arms from one point in the corner below right, to the patient's left, back and head as they are seen now.
struct OrientationSign {
    ScreenFromPatient toScreen;
    int widthPx = 0;   ///< of the picture, device px
    double pixelScale = 1.0;   ///< device px per px

    Eigen::Vector2d center() const;   ///< device px from the bottom left
};

/// A letter of the sign (L, P, H) and where its centre goes, device px from the bottom left.
struct OrientationLetter {
    char letter = ' ';
    Eigen::Vector2d at;
    bool pointsToViewer = false;
};

void addOrientationSign(StrokeMesh& mesh, const OrientationSign& sign, const Palette& tones);

/// At the ends of the arms; none where an arm points along the sight, or a letter would cover another.
std::vector<OrientationLetter> lettersOf(const OrientationSign& sign);

}   // namespace angiopose::ui
