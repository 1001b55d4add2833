#include "tests/benchmark/foreign/traced_widths.h"

#include "tests/benchmark/foreign/detector.h"

#include <algorithm>
#include <cmath>

namespace angiopose::benchmarks {

double WideLine::widthAt(const Eigen::Vector2d& pixel) const
{
    double nearest = 25.0;   // px²
    double radius = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (const double squared = (at[i] - pixel).squaredNorm(); squared < nearest) {
            nearest = squared;
            radius = radiusPx[i];
        }
    }
    return radius;
}

WideLine wideLines(const RootedTree& shown, const std::vector<std::size_t>& filled,
                   const core::RigidTransform& cameraFromPatient)
{
    WideLine lines;
    for (const std::size_t branch : filled) {
        const core::VesselBranch& vessel = shown.tree.branches[branch];
        for (std::size_t i = 0; i < vessel.radiusMm.size(); ++i) {
            const Eigen::Vector3d inCamera = cameraFromPatient * vessel.pointsInPatient[i];
            lines.at.push_back(pixelOf(inCamera));
            lines.radiusPx.push_back(vessel.radiusMm[i] * sourceToDetectorMm / inCamera.z() / pixelMm);
        }
    }
    return lines;
}

void addWidths(core::Centerline2d& target, const WideLine& lines, ForeignRandom random)
{
    constexpr double narrowestPx = 0.75;
    constexpr double keptAlong = 0.91;
    const double bias = std::exp(0.12 * random.normal());
    for (core::Curve2d& curve : target.curves) {
        const double foreignPx = random.uniform(1.0, 5.0);
        double wander = random.normal();
        for (const Eigen::Vector2d& pixel : curve.pointsPx) {
            wander = keptAlong * wander + std::sqrt(1.0 - keptAlong * keptAlong) * random.normal();
            const double ownPx = lines.widthAt(pixel);
            const double trueness = bias * std::exp(0.2 * wander);
            curve.radiusPx.push_back(std::max(narrowestPx, trueness * (ownPx > 0.0 ? ownPx : foreignPx)));
        }
    }
}

}   // namespace angiopose::benchmarks
