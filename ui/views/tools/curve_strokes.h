#pragma once

#include "core/vessel/centerline2d.h"
#include "ui/scenes/stroke_mesh.h"

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace angiopose::ui {

/// Canvas onto which image curves are drawn, in device px, y up.
struct CurveCanvas {
    Eigen::Affine2d canvasFromImage = Eigen::Affine2d::Identity();
    double widthPx = 0.0;
    double heightPx = 0.0;
    double pixelRatio = 1.0;   ///< device px per px at 100 % scale

    bool isSame(const CurveCanvas& other) const;
};

/// Maps points to the canvas as a line of one color, without coincident points.
StrokeLine lineOn(const CurveCanvas& canvas, const std::vector<Eigen::Vector2d>& pointsPx, const Color& tone);

/// Adds the visible parts of a line with a shadow, which makes it readable over bright and dark vessels; widths in px.
void addShadowed(StrokeMesh& mesh, const CurveCanvas& canvas, const StrokeLine& line, double widthPx, double opacity);
void addShadowedDashes(StrokeMesh& mesh, const CurveCanvas& canvas, const StrokeLine& line, double widthPx,
                       double dashPx);

/// Style of curves that are not being edited: suspects are dashed amber, devices dashed white. If `isFaint` is true,
/// all curves are faint.
struct CurveStyle {
    double widthPx = 2.2;   ///< width in px at 100 % scale
    std::vector<int> suspectIds = {};
    std::vector<int> deviceIds = {};
    bool isFaint = false;
};
void addCurves(StrokeMesh& mesh, const CurveCanvas& canvas, const core::Centerline2d& curves, const CurveStyle& style);

/// Caches strokes of unedited curves until the curves or the view change, since mouse moves are far more frequent.
class CurveStrokeCache {
public:
    /// Returns the strokes; an equal `revision` means that curves and style are unchanged.
    const StrokeMesh& of(int revision, const CurveCanvas& canvas, const core::Centerline2d& curves,
                         const CurveStyle& style);

private:
    struct Entry {
        int revision = 0;
        CurveCanvas canvas;
        StrokeMesh mesh;
    };
    std::optional<Entry> entry_;
};

}   // namespace angiopose::ui
