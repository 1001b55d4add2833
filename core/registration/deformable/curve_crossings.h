#pragma once

#include "core/geometry/projection_camera.h"
#include "core/registration/problem/registration_problem.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace angiopose::core {

/// Crossing of a traced curve with a line across a projected vessel.
struct CurveCrossing {
    double offsetPx = 0.0;   ///< signed distance along the line from its origin on the vessel
    double turn = 0.0;   ///< angle between the directions of vessel and curve, rad, 0…π/2
    int curve = -1;
};

/// Line in the image along which to search for crossings.
struct CrossingQuery {
    Eigen::Vector2d positionPx;
    Eigen::Vector2d normal;   ///< unit vector along the line
    double reachPx = 0.0;   ///< search range on either side of the vessel
};

/// Traced curves, smoothed to subpixel accuracy and binned into cells for fast crossing queries.
class CurveCrossings {
public:
    CurveCrossings(const TargetSamples& target, const ProjectionCamera& camera);

    /// Whether there are curves; false if no two target points belong to the same curve.
    bool hasCurves() const { return !pieces_.empty(); }

    /// Finds up to `maxCount` crossings in range whose direction differs from the vessel by less than `maxAngle` (rad),
    /// nearest first.
    void find(const CrossingQuery& query, double maxAngle, std::size_t maxCount,
              std::vector<CurveCrossing>& crossings) const;

private:
    /// Straight segment between neighboring points of a curve.
    struct Piece {
        Eigen::Vector2d from;
        Eigen::Vector2d along;
        Eigen::Vector2d direction;   ///< unit direction, averaged over the neighboring points of the curve
        int curve = -1;
    };

    void sortIntoCells(const ProjectionCamera& camera);
    void addCrossing(const Piece& piece, const CrossingQuery& query, double minCosine,
                     std::vector<CurveCrossing>& crossings) const;

    std::vector<Piece> pieces_;   ///< line segments sorted by cell
    std::vector<std::int32_t> starts_;   ///< index of the first piece of each cell, row by row, with an end entry
    int columns_ = 0;
    int rows_ = 0;
};

}   // namespace angiopose::core
