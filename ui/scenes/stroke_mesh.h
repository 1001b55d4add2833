#pragma once

#include "ui/theme/theme.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace angiopose::ui {

struct StrokePoint {
    Eigen::Vector2d at;
    Color color;
};
using StrokeLine = std::vector<StrokePoint>;

struct Pen {
    double widthPx = 2.0;
    double opacity = 1.0;
    double fadePx = 1.0;   ///< width of the soft edge; large values make a glow
};

/// Vector shape as requested by the caller. A line with one point is a dot.
struct StrokeShape {
    enum class Kind { Line, Ribbon };
    Kind kind = Kind::Line;
    StrokeLine line;   ///< for a ribbon, one edge
    StrokeLine other;   ///< for a ribbon, the other edge
    Pen pen;   ///< for a ribbon, only its opacity is used
};

/// Triangles of smooth-edged lines and dots, in device px, y up. Edges fade over one pixel, which makes multisampling
/// unnecessary.
struct StrokeMesh {
    std::vector<float> points;   ///< x, y, 0 per vertex
    std::vector<std::uint8_t> colors;   ///< RGBA per vertex
    std::vector<std::int32_t> triangles;   ///< 3 vertices each
    std::vector<StrokeShape>* shapes = nullptr;   ///< if set, collects shapes instead of triangles, for vector export

    void clear();
    std::size_t vertexCount() const { return points.size() / 3; }
};

struct DashPattern {
    double drawnPx = 0.0;
    double gapPx = 0.0;
};

/// Adds a line with round joints and ends; a line without length becomes a dot.
void addLine(StrokeMesh& mesh, const StrokeLine& raw, const Pen& pen);

/// Adds a filled dot.
void addDot(StrokeMesh& mesh, const StrokePoint& center, double radiusPx, double opacity);

/// Fills the area between two lines with the same number of points, in the first line's colors.
void addRibbon(StrokeMesh& mesh, const StrokeLine& left, const StrokeLine& right, double opacity);

/// Returns the parts of the line inside `lower`…`upper`, cut at its border.
std::vector<StrokeLine> clipped(const StrokeLine& line, const Eigen::Vector2d& lower, const Eigen::Vector2d& upper);

/// Returns the dashes of a line.
std::vector<StrokeLine> dashed(const StrokeLine& line, const DashPattern& pattern);

/// Removes points nearer than `minimumStepPx` to their predecessor; keeps both ends.
StrokeLine thinned(const StrokeLine& line, double minimumStepPx);

}   // namespace angiopose::ui