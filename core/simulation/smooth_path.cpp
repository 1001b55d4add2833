#include "core/simulation/smooth_path.h"

#include "core/vessel/polyline.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr double pathSpacingMm = 1.0;

/// One lateral wave along a vessel.
struct LateralWave {
    double amplitudeMm;
    double waveLengthMm;
    double phase;
    Eigen::Vector3d axis;
};

/// Draws two long waves and a shorter, smaller one; the radius of curvature of each wave stays above about 15 mm.
std::array<LateralWave, 3> drawLateralWaves(const Eigen::Vector3d& chord, double tortuosity, CounterRandom& random)
{
    const Eigen::Vector3d u = chord.unitOrthogonal();
    const Eigen::Vector3d v = chord.normalized().cross(u);
    const std::array<double, 3> shortestMm{60.0, 45.0, 24.0};
    std::array<LateralWave, 3> waves{};
    for (std::size_t i = 0; i < waves.size(); ++i) {
        const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
        const double waveLengthMm = shortestMm[i] * random.uniform(1.0, 1.5);
        waves[i] = {tortuosity * waveLengthMm * random.uniform(0.015, 0.05), waveLengthMm,
                    random.uniform(0.0, 2.0 * std::numbers::pi), std::cos(turn) * u + std::sin(turn) * v};
    }
    return waves;
}

Eigen::Vector3d bezier(const std::array<Eigen::Vector3d, 4>& control, double t)
{
    const double s = 1.0 - t;
    return s * s * s * control[0] + 3.0 * s * s * t * control[1] + 3.0 * s * t * t * control[2] +
           t * t * t * control[3];
}

}   // namespace

std::vector<Eigen::Vector3d> smoothPath(const PathPlan& plan, CounterRandom& random)
{
    const Eigen::Vector3d chord = plan.end - plan.start;
    const double reach = 0.36 * chord.norm();
    const std::array<Eigen::Vector3d, 4> control{plan.start, plan.start + reach * plan.startDirection,
                                                 plan.end - reach * plan.endDirection, plan.end};
    const std::array<LateralWave, 3> waves = drawLateralWaves(chord, plan.tortuosity, random);

    const int steps = std::max(8, static_cast<int>(2.0 * chord.norm()));
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        const double alongMm = t * chord.norm();
        // The waves fade in to let the vessel leave its parent in the planned direction.
        const double faded = 1.0 - std::exp(-alongMm * alongMm / (15.0 * 15.0));
        Eigen::Vector3d point = bezier(control, t);
        for (const LateralWave& wave : waves) {
            const double angle = 2.0 * std::numbers::pi * alongMm / wave.waveLengthMm + wave.phase;
            point += faded * wave.amplitudeMm * std::sin(angle) * wave.axis;
        }
        points.push_back(point);
    }
    return interpolate(points, evenStations<3>(points, pathSpacingMm));
}

}   // namespace angiopose::core
