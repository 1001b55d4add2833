#include "core/tracing/volume/path/voxel_cost.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double farAboveBlood = 1.4;   // relative to the lumen contrast; bone, plaque and metal are brighter
constexpr double dimming = 3.0;   // decay rate of the similarity above `farAboveBlood`
constexpr double shareWithoutTube = 0.15;   // weight of a voxel with the intensity of a vessel but not in a tube

/// Returns the similarity to the lumen: 0 in tissue, 1 in the lumen, lower again for far brighter values.
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
