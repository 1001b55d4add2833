#pragma once

#include "core/vessel/centerline2d.h"
#include "ui/scenes/stroke_mesh.h"

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace angiopose::ui {

/// Target for drawing image curves: device px, y up.
struct CurveCanvas {
    Eigen::Affine2d canvasFromImage = Eigen::Affine2d::Identity();
    double widthPx = 0.0;
    double heightPx = 0.0;
    double pixelRatio = 1.0;   ///< device px per px at 100 %

    bool isSame(const CurveCanvas& other) const;
};

/// Returns the mapped points in one color, without coinciding points.
StrokeLine lineOn(const CurveCanvas& canvas, const std::vector<Eigen::Vector2d>& pointsPx, const Color& tone);

/// Adds the visible parts of a line with a shadow, which makes it readable over bright and dark vessels; widths in px.
void addShadowed(StrokeMesh& mesh, const CurveCanvas& canvas, const StrokeLine& line, double widthPx, double opacity);
void addShadowedDashes(StrokeMesh& mesh, const CurveCanvas& canvas, const StrokeLine& line, double widthPx,
                       double dashPx);

/// Style of curves that are not being edited: suspects are dashed amber, devices dashed white. `isFaint` draws all
/// curves as a faint trace.
struct CurveLook {
    double widthPx = 2.2;   ///< at 100 % scale
    std::vector<int> inDoubt = {};
    std::vector<int> apart = {};
    bool isFaint = false;
};
void addCurves(StrokeMesh& mesh, const CurveCanvas& canvas, const core::Centerline2d& curves, const CurveLook& look);

/// Caches the strokes of curves that are not being edited until the curves or the view change, because the mouse moves
/// far more often.
class KeptCurveStrokes {
public:
    /// `revision` identifies curves and look: equal numbers mean both are unchanged.
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
