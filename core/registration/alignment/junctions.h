#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace angiopose::core {

/// A place where curves meet, and which ways they leave it.
template <int Dimension>
struct Junction {
    using Vector = Eigen::Matrix<double, Dimension, 1>;

    Vector point;
    std::vector<Vector> directions;   ///< unit, away from it
};

/// How curves are looked at where they meet, in the unit of their points.
struct JunctionScale {
    double touching;   ///< an end this near to another curve meets it
    double leaving;   ///< a direction is taken over this length
};

/// Where an end of one curve touches another and at least three ways lead off. `curveIndex` ascends.
template <int Dimension>
std::vector<Junction<Dimension>> junctionsOf(std::span<const Eigen::Matrix<double, Dimension, 1>> points,
                                             std::span<const int> curveIndex, const JunctionScale& scale);

extern template std::vector<Junction<2>> junctionsOf<2>(std::span<const Eigen::Vector2d>, std::span<const int>,
                                                        const JunctionScale&);
extern template std::vector<Junction<3>> junctionsOf<3>(std::span<const Eigen::Vector3d>, std::span<const int>,
                                                        const JunctionScale&);

}   // namespace angiopose::core