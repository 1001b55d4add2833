#include "core/tracing/volume/path/voxel_cost.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double farAboveBlood = 1.4;   // bone, chalk and metal: beyond blood's height over tissue by this
constexpr double dimming = 3.0;   // of the likeness, beyond it
constexpr double shareWithoutTube = 0.15;   // of what speaks for a vessel, as bright as one but no tube

/// 0…1 between tissue and blood; less again for what is brighter than blood.
double likeness(double value, const VesselLook& look)
{
    const double fill = (value - look.tissue) / (look.blood - look.tissue);
    return fill <= farAboveBlood ? std::clamp(fill, 0.0, 1.0) : std::exp(-dimming * (fill - farAboveBlood));
}

}   // namespace

double costOfVoxel(const PathGround& ground, const Eigen::Vector3i& voxel, const VesselLook& look)
{
    const double value = ground.valueAt(voxel);
    return likeness(value, look) > 0.0 ? costOfTube(value, ground.tubeShare(voxel, look.tissue), look) : dearestPerMm;
}

double costOfTube(double value, double share, const VesselLook& look)
{
    const double like = likeness(value, look);
    return 1.0 / (1.0 / dearestPerMm + like * like * (shareWithoutTube + (1.0 - shareWithoutTube) * share));
}

}   // namespace angiopose::core
