#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace angiopose::core {

/// A connected piece of what could be traced.
struct TracedPiece {
    std::size_t voxels = 0;
    double lengthMm = 0.0;   ///< of the branches in it; 0: it was left out
    bool isAskedFor = false;   ///< else it was not looked at
    Eigen::Vector3d placeInPatient = Eigen::Vector3d::Zero();   ///< LPS mm; a seed there asks for it
    double share = 0.0;   ///< of the voxels of all pieces

    bool isTraced() const { return lengthMm > 0.0; }
};

}   // namespace angiopose::core
