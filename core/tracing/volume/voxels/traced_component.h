#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace angiopose::core {

/// A connected component that can be traced.
struct TracedComponent {
    std::size_t voxels = 0;
    double lengthMm = 0.0;   ///< total length of its branches; 0 if excluded
    bool isRequested = false;   ///< whether the component was evaluated
    Eigen::Vector3d positionInPatient = Eigen::Vector3d::Zero();   ///< LPS, mm; a seed here selects the component
    double share = 0.0;   ///< fraction of the voxels of all components

    bool isTraced() const { return lengthMm > 0.0; }
};

}   // namespace angiopose::core
