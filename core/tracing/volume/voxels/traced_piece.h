#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace angiopose::core {

/// A connected component of what could be traced.
struct TracedPiece {
    std::size_t voxels = 0;
    double lengthMm = 0.0;   ///< length of its branches; 0: left out
    bool isAskedFor = false;   ///< false: it was not evaluated
    Eigen::Vector3d placeInPatient = Eigen::Vector3d::Zero();   ///< LPS mm; a seed there selects it
    double share = 0.0;   ///< share of the voxels of all components

    bool isTraced() const { return lengthMm > 0.0; }
};

}   // namespace angiopose::core
