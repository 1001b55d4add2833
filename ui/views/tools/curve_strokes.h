#pragma once

#include "core/vessel/centerline2d.h"
#include "ui/scenes/stroke_mesh.h"

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace angiopose::ui {

/// The picture that curves of an image are drawn on: device px, y up.
struct CurveCanvas {
    Eigen::Affine2d canvasFromImage = Eigen::Affine2d::Identity();
    double widthPx = 0.0;
    double heightPx = 0.0;
    double pixelRatio = 1.0;   ///< device px per px at 100 %

    bool isSame(const CurveCanvas& other) const;
};

/// The points on the picture in one colour, without those that fall together.
StrokeLine lineOn(const CurveCanvas& canvas, const std::vector<Eigen::Vector2d>& pointsPx, const Color& tone);

/// Adds what lies on the picture of a line with its shadow: light vessels and dark ones lie below. px.
void addShadowed(StrokeMesh& mesh, const CurveCanvas& canvas, const StrokeLine& line, double widthPx, double opacity);
void addShadowedDashes(StrokeMesh& mesh, const CurveCanvas& canvas, const StrokeLine& line, double widthPx,
                       double dashPx);

/// How curves at rest look: those in doubt are dashed amber, those that are no vessels dashed white. `isFaint`: all of
/// them as a trace that is left behind.
struct CurveLook {
    double widthPx = 2.2;   ///< at 100 %
    std::vector<int> inDoubt = {};
    std::vector<int> apart = {};
    bool isFaint = false;
};
void addCurves(StrokeMesh& mesh, const CurveCanvas& canvas, const core::Centerline2d& curves, const CurveLook& look);

/// The strokes of curves at rest, kept until the curves or the picture change: the mouse moves far more often.
class KeptCurveStrokes {
public:
    /// `revision` names the curves and the look: the same number means the same of both.
    const StrokeMesh& of(int revision, const CurveCanvas& canvas, const core::Centerline2d& curves,
                         const CurveLook& look);

private:
    struct Kept {
        int revision = 0;
        CurveCanvas canvas;
        StrokeMesh mesh;
    };
    std::optional<Kept> kept_;
};

}   // namespace angiopose::ui
