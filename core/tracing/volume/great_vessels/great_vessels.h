#pragma once

#include "core/tracing/volume/great_vessels/block_opacification.h"
#include "core/tracing/volume/great_vessels/find_trunks.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Trunks that continue each other, such as the ascending aorta, arch and descending aorta.
struct GreatVessel {
    std::vector<Trunk> trunks;   ///< highest score first

    Eigen::Vector3d centerInPatient() const;   ///< halfway along the first trunk
    double score() const;
    bool surrounds(const Eigen::Vector3d& positionInPatient) const;   ///< whether the point lies within a section
};

/// Finds the great vessels of a scan, highest score first. Incomplete when stopped.
std::vector<GreatVessel> assembleGreatVessels(const BlockOpacification& blood, int threads, TracingProgress& progress);

}   // namespace angiopose::core
