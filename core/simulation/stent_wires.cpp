#include "core/simulation/stent_wires.h"

#include "core/vessel/polyline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace angiopose::core {

VesselTree stentWires(const VesselBranch& branch, const StentOptions& options)
{
    VesselTree wires;
    if (branch.pointsInPatient.size() < 2) {
        return wires;
    }
    const double slope = std::tan(options.steepnessDeg * std::numbers::pi / 180.0);
    const std::vector<PolylineStation> stations = evenStations<3>(branch.pointsInPatient, options.wireRadiusMm);
    const std::vector<Eigen::Vector3d> axis = interpolate(branch.pointsInPatient, stations);
    const std::vector<double> radii = interpolate(branch.radiusMm, stations);
    const std::vector<Eigen::Vector3d> tangents = polylineTangents<3>(axis, 2);
    const auto count = static_cast<double>(axis.size());
    const auto first = static_cast<std::size_t>(options.startFraction * count);
    const auto last = std::min(axis.size(), static_cast<std::size_t>(options.endFraction * count));
    wires.branches.resize(2 * static_cast<std::size_t>(options.helices));
    Eigen::Vector3d aside = tangents[first].unitOrthogonal();
    double turn = 0.0;
    for (std::size_t n = first; n < last; ++n) {
        aside = (aside - aside.dot(tangents[n]) * tangents[n]).normalized();   // keeps the local frame from twisting
        const Eigen::Vector3d across = tangents[n].cross(aside);
        turn += n > first ? slope * (axis[n] - axis[n - 1]).norm() / radii[n] : 0.0;
        for (std::size_t w = 0; w < wires.branches.size(); ++w) {
            const std::size_t helix = w / 2;
            const double start = 2.0 * std::numbers::pi * static_cast<double>(helix) / options.helices;
            const double angle = start + (w % 2 == 0 ? turn : -turn);
            wires.branches[w].pointsInPatient.emplace_back(
                axis[n] + radii[n] * (std::cos(angle) * aside + std::sin(angle) * across));
            wires.branches[w].radiusMm.push_back(options.wireRadiusMm);
        }
    }
    return wires;
}

}   // namespace angiopose::core
