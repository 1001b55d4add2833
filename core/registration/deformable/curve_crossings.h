#pragma once

#include "core/geometry/projection_camera.h"
#include "core/registration/problem/registration_problem.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Crossing of a traced curve with a line across a projected vessel.
struct CurveCrossing {
    double offsetPx = 0.0;   ///< along the line, measured from the point through which it is drawn
    double turn = 0.0;   ///< angle between the directions of vessel and curve, rad, 0…π/2
    int curve = -1;
};

/// Line in the image along which to search.
struct CrossingQuery {
    Eigen::Vector2d placePx;
    Eigen::Vector2d normal;   ///< unit vector along the line
    double reachPx = 0.0;   ///< search length on either side
};

/// Traced curves, smoothed to subpixel accuracy and binned into cells, for finding their crossings with lines.
class CurveCrossings {
public:
    CurveCrossings(const TargetSamples& target, const ProjectionCamera& camera);

    /// False if no two target points are connected by a curve.
    bool hasCurves() const { return !pieces_.empty(); }

    /// Finds the crossings within reach whose direction differs by less than `greatestTurn` (rad), nearest first, at
    /// most `most`.
    void find(const CrossingQuery& query, double greatestTurn, std::size_t most,
              std::vector<CurveCrossing>& crossings) const;

private:
    /// Straight segment between neighboring points of a curve.
    struct Piece {
        Eigen::Vector2d from;
        Eigen::Vector2d along;
        Eigen::Vector2d direction;   ///< unit vector, direction of the surrounding curve
        int curve = -1;
    };

    void sortIntoCells(const ProjectionCamera& camera);
    void meet(const Piece& piece, const CrossingQuery& query, double minCosine,
              std::vector<CurveCrossing>& crossings) const;

    std::vector<Piece> pieces_;   ///< sorted by cell
    std::vector<std::int32_t> starts_;   ///< index of the first piece of each cell, row by row, and the end
    int columns_ = 0;
    int rows_ = 0;
};

}   // namespace angiopose::core
