#include "core/simulation/deform_tree.h"

#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr double correlationMm = 40.0;
constexpr int featureCount = 128;

struct Wave {
    Eigen::Vector3d frequency;   ///< rad/mm
    double phase;
    Eigen::Vector3d amplitude;   ///< mm
};

Eigen::Vector3d normalVector(CounterRandom& random)
{
    const double x = random.normal();
    const double y = random.normal();
    const double z = random.normal();
    return {x, y, z};
}

}   // namespace

VesselTree deformed(const VesselTree& tree, double standardDeviationMm, CounterRandom& random)
{
    std::vector<Wave> waves;
    for (int i = 0; i < featureCount; ++i) {
        const Eigen::Vector3d frequency = normalVector(random) / correlationMm;
        const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
        waves.push_back({frequency, phase, std::sqrt(2.0 / featureCount) * standardDeviationMm * normalVector(random)});
    }
    VesselTree result = tree;
    for (VesselBranch& branch : result.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            Eigen::Vector3d shift = Eigen::Vector3d::Zero();
            for (const Wave& wave : waves) {
                shift += std::cos(wave.frequency.dot(point) + wave.phase) * wave.amplitude;
            }
            point += shift;
        }
    }
    return result;
}

}   // namespace angiopose::core
