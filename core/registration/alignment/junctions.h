#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace angiopose::core {

/// Point where curves meet, with the directions in which they leave.
template <int Dimension>
struct Junction {
    using Vector = Eigen::Matrix<double, Dimension, 1>;

    Vector point;
    std::vector<Vector> directions;   ///< unit vectors pointing away from the junction
};

/// Lengths used for junction detection, in the unit of the curve points.
struct JunctionScale {
    double maxGap;   ///< maximum distance between a curve end and another curve that it touches
    double directionLength;   ///< length over which a direction is measured
};

/// Returns the points where a curve end touches another curve and at least three directions lead away. `curveIndex`
/// must be ascending.
template <int Dimension>
std::vector<Junction<Dimension>> findJunctions(std::span<const Eigen::Matrix<double, Dimension, 1>> points,
                                               std::span<const int> curveIndex, const JunctionScale& scale);

extern template std::vector<Junction<2>> findJunctions<2>(std::span<const Eigen::Vector2d>, std::span<const int>,
                                                          const JunctionScale&);
extern template std::vector<Junction<3>> findJunctions<3>(std::span<const Eigen::Vector3d>, std::span<const int>,
                                                          const JunctionScale&);

}   // namespace angiopose::core
