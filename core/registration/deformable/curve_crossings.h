#pragma once

#include "core/geometry/projection_camera.h"
#include "core/registration/problem/registration_problem.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Where a line across a projected vessel meets a traced curve.
struct CurveCrossing {
    double offsetPx = 0.0;   ///< along the line, from the place it was drawn through
    double turn = 0.0;   ///< between the directions of vessel and curve, rad, 0…π/2
    int curve = -1;
};

/// A line of the image to look along.
struct CrossingQuery {
    Eigen::Vector2d placePx;
    Eigen::Vector2d normal;   ///< unit: along the line
    double reachPx = 0.0;   ///< to either side
};

/// The traced curves, smoothed below the pixel grid and sorted into cells, to find where lines meet them.
class CurveCrossings {
public:
    CurveCrossings(const TargetSamples& target, const ProjectionCamera& camera);

    /// False where no two target points are joined to a curve.
    bool hasCurves() const { return !pieces_.empty(); }

    /// Crossings within reach whose direction differs by less than `greatestTurn` (rad), nearest first, at most `most`.
    void find(const CrossingQuery& query, double greatestTurn, std::size_t most,
              std::vector<CurveCrossing>& crossings) const;

private:
    /// Straight piece between neighbouring points of a curve.
    struct Piece {
        Eigen::Vector2d from;
        Eigen::Vector2d along;
        Eigen::Vector2d direction;   ///< unit, of the curve around it
        int curve = -1;
    };

    void sortIntoCells(const ProjectionCamera& camera);
    void meet(const Piece& piece, const CrossingQuery& query, double minCosine,
              std::vector<CurveCrossing>& crossings) const;

    std::vector<Piece> pieces_;   ///< by cell
    std::vector<std::int32_t> starts_;   ///< of each cell among the pieces, row by row, and the end
    int columns_ = 0;
    int rows_ = 0;
};

}   // namespace angiopose::core
