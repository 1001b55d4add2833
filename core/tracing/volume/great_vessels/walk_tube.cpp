#include "core/tracing/volume/great_vessels/walk_tube.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace angiopose::core {
namespace {

constexpr double minTrustInWall = 0.5;   ///< a sixth of the rays may miss the wall, at branch origins
constexpr double minFlatTrust = 0.1;   ///< for a closed section, such as the true lumen of a dissection
constexpr double minClosed = 0.95;
constexpr double maxWidening = 1.3;   ///< between consecutive sections
constexpr double maxAside = 0.5;   ///< in radii, from the expected point to the section's center
constexpr double stepInRadii = 0.5;
constexpr int maxMissed = 3;   ///< consecutive sections: a wide branch origin spans one or two diameters
constexpr int maxSteps = 1000;

/// Current state of the tracking.
struct Walker {
    Eigen::Vector3d pointMm;
    Eigen::Vector3d direction;
    double radiusMm;
};

/// Whether the section is round, or flattened with walls on all sides.
bool isTube(const CrossSection& section)
{
    return section.trust >= minTrustInWall || (section.trust >= minFlatTrust && section.closed >= minClosed);
}

bool isLike(const CrossSection& section, const Eigen::Vector3d& expected, double radiusMm)
{
    return isTube(section) && section.radiusMm <= maxWidening * radiusMm &&
           radiusMm <= maxWidening * section.radiusMm && (section.centerMm - expected).norm() <= maxAside * radiusMm;
}

/// Start section across the vessel: the smallest of the round sections in 13 directions.
std::optional<Walker> startAt(const Eigen::Vector3d& startMm, double radiusMm, const TubeGround& ground)
{
    std::optional<Walker> best;
    for (int n = 14; n < 27; ++n) {   // one of each pair of opposite neighbors
        const Eigen::Vector3i neighbor(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        const Eigen::Vector3d direction = neighbor.cast<double>().normalized();
        const CrossSection section = crossSection({startMm, direction, radiusMm, ground.voxelMm}, ground.fill);
        if (section.trust >= minTrustInWall && (!best || section.radiusMm < best->radiusMm)) {
            best = Walker{section.centerMm, direction, section.radiusMm};
        }
    }
    return best;
}

/// Tracks in one direction from the start, excluding the start.
Tube walkOneWay(Walker walker, const TubeGround& ground)
{
    Tube tube;
    Eigen::Vector3d last = walker.pointMm;
    int missed = 0;
    for (int step = 0; step < maxSteps && missed <= maxMissed; ++step) {
        const Eigen::Vector3d expected =
            walker.pointMm + std::max(ground.voxelMm, stepInRadii * walker.radiusMm) * walker.direction;
        if ((expected.array() < 0.0).any() || (expected.array() > ground.highMm.array()).any()) {
            break;
        }
        const CrossSection section =
            crossSection({expected, walker.direction, walker.radiusMm, ground.voxelMm}, ground.fill);
        if (!isLike(section, expected, walker.radiusMm)) {
            ++missed;
            walker.pointMm = expected;
            continue;
        }
        missed = 0;
        const Eigen::Vector3d way = (section.centerMm - last).normalized();
        walker = {section.centerMm, (walker.direction + way).normalized(), 0.5 * (walker.radiusMm + section.radiusMm)};
        last = section.centerMm;
        tube.pointsMm.push_back(section.centerMm);
        tube.radiusMm.push_back(section.radiusMm);
    }
    return tube;
}

}   // namespace

Tube walkTube(const Eigen::Vector3d& startMm, double radiusMm, const TubeGround& ground)
{
    const auto start = startAt(startMm, radiusMm, ground);
    if (!start) {
        return {{startMm}, {radiusMm}};
    }
    Tube tube = walkOneWay({start->pointMm, -start->direction, start->radiusMm}, ground);
    std::reverse(tube.pointsMm.begin(), tube.pointsMm.end());
    std::reverse(tube.radiusMm.begin(), tube.radiusMm.end());
    tube.pointsMm.push_back(start->pointMm);
    tube.radiusMm.push_back(start->radiusMm);
    const Tube ahead = walkOneWay(*start, ground);
    tube.pointsMm.insert(tube.pointsMm.end(), ahead.pointsMm.begin(), ahead.pointsMm.end());
    tube.radiusMm.insert(tube.radiusMm.end(), ahead.radiusMm.begin(), ahead.radiusMm.end());
    return tube;
}

}   // namespace angiopose::core