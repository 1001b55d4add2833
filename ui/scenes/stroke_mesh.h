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
    double fadePx = 1.0;   ///< width of the soft edge; large values give a glow
};

/// Line or ribbon before triangulation, for vector export. A line with a single point is a dot.
struct StrokeShape {
    enum class Kind { Line, Ribbon };
    Kind kind = Kind::Line;
    StrokeLine line;   ///< points of the line, or one edge of a ribbon
    StrokeLine other;   ///< other edge of a ribbon
    Pen pen;   ///< a ribbon uses only the opacity
};

/// Triangles that form lines and dots with smooth edges, in device px, y up. Edges fade over one pixel, which makes
/// multisampling unnecessary.
struct StrokeMesh {
    std::vector<float> points;   ///< x, y, 0 per vertex
    std::vector<std::uint8_t> colors;   ///< RGBA per vertex
    std::vector<std::int32_t> triangles;   ///< three vertex indices per triangle
    std::vector<StrokeShape>* shapes = nullptr;   ///< if set, collects shapes instead of triangles, for vector export

    void clear();
    std::size_t vertexCount() const { return points.size() / 3; }
};

struct DashPattern {
    double dashPx = 0.0;
    double gapPx = 0.0;
};

/// Adds a line with round ends and, at sharp turns, round joints; a line of zero length becomes a dot.
void addLine(StrokeMesh& mesh, const StrokeLine& raw, const Pen& pen);

void addDot(StrokeMesh& mesh, const StrokePoint& center, double radiusPx, double opacity);

/// Fills the area between two lines with equal numbers of points, in the colors of `left`.
void addRibbon(StrokeMesh& mesh, const StrokeLine& left, const StrokeLine& right, double opacity);

/// Returns the parts of the line inside the box from `lower` to `upper`.
std::vector<StrokeLine> clipLine(const StrokeLine& line, const Eigen::Vector2d& lower, const Eigen::Vector2d& upper);

/// Splits a line into dashes.
std::vector<StrokeLine> splitIntoDashes(const StrokeLine& line, const DashPattern& pattern);

/// Removes points closer than `minimumStepPx` to the previous point; keeps both end points.
StrokeLine thinLine(const StrokeLine& line, double minimumStepPx);

}   // namespace angiopose::ui
