#include "core/tracing/volume/path/voxel_cost.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double maxLumenIntensity = 1.4;   // relative to the lumen contrast; bone, plaque and metal are brighter
constexpr double similarityDecay = 3.0;   // decay rate of the similarity above `maxLumenIntensity`
constexpr double weightWithoutTube = 0.15;   // weight of a voxel with the intensity of a vessel but not in a tube

/// Returns the similarity to the lumen: 0 in tissue, 1 in the lumen, lower again for far brighter values.
double similarityTo(double value, const VesselAppearance& appearance)
{
    const double opacification = (value - appearance.tissue) / (appearance.blood - appearance.tissue);
    return opacification <= maxLumenIntensity ? std::clamp(opacification, 0.0, 1.0)
                                              : std::exp(-similarityDecay * (opacification - maxLumenIntensity));
}

}   // namespace

double costOfVoxel(const TubeDetector& detector, const Eigen::Vector3i& voxel, const VesselAppearance& appearance)
{
    const double value = detector.valueAt(voxel);
    return similarityTo(value, appearance) > 0.0
               ? costOfTube(value, detector.tubeResemblance(voxel, appearance.tissue), appearance)
               : maxCostPerMm;
}

double costOfTube(double value, double fraction, const VesselAppearance& appearance)
{
    const double similarity = similarityTo(value, appearance);
    return 1.0 /
           (1.0 / maxCostPerMm + similarity * similarity * (weightWithoutTube + (1.0 - weightWithoutTube) * fraction));
}

}   // namespace angiopose::core
