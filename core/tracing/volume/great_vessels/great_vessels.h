#pragma once

#include "core/tracing/volume/great_vessels/coarse_blood.h"
#include "core/tracing/volume/great_vessels/find_trunks.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Trunks that continue one another: the parts of an aorta before, in and behind its arch.
struct GreatVessel {
    std::vector<Trunk> trunks;   ///< that of the greatest worth first

    Eigen::Vector3d middleInPatient() const;   ///< half way along the first trunk
    double worth() const;
    bool surrounds(const Eigen::Vector3d& placeInPatient) const;   ///< within one of the sections
};

/// The great vessels of a scan, that of the greatest worth first. Incomplete when stopped.
std::vector<GreatVessel> greatVessels(const CoarseBlood& blood, int threads, TracingProgress& progress);

}   // namespace angiopose::core