#include "core/tracing/volume/path/look_along_path.h"

#include "core/imaging/interpolate_grid.h"
#include "core/support/quantile.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double lookEveryMm = 2.0;
constexpr std::ptrdiff_t steadyReach = 7;   // places before and behind: stents, chalk and gaps do not count as blood
constexpr double bloodRank = 0.75;   // of these: thin stretches are dim by blurring
constexpr double besideInShells = 1.5;   // how far from the axis what is around a vessel begins
constexpr double clearlyDarker = 0.5;   // of the vessel's height: not another vessel beside it
constexpr std::size_t leastAround = 6;   // of 26 places

/// What is right beside the vessel, where enough is darker than it; else what is farther around.
VesselLook lookBeside(const PathGround& ground, const Eigen::Vector3i& voxel)
{
    VesselLook look = ground.lookAt(voxel);
    std::vector<double> around;
    for (const double value : ground.valuesAround(voxel, besideInShells * ground.tube(voxel, look.tissue).shellMm)) {
        if (value < look.blood - clearlyDarker * (look.blood - look.tissue)) {
            around.push_back(value);
        }
    }
    if (around.size() >= leastAround) {
        look.tissue = medianOf(around);
    }
    return look;
}

}   // namespace

LookAlongPath::LookAlongPath(const PathGround& ground, const std::vector<Eigen::Vector3d>& pointsMm)
    : volume_(ground.volume())
{
    const Eigen::Vector3d& spacing = volume_.geometry.spacingMm;
    double walkedMm = lookEveryMm;
    for (std::size_t n = 0; n < pointsMm.size(); ++n) {
        walkedMm += n > 0 ? (pointsMm[n] - pointsMm[n - 1]).norm() : 0.0;
        if (walkedMm >= lookEveryMm) {
            placesMm_.push_back(pointsMm[n]);
            looks_.push_back(lookBeside(ground, pointsMm[n].cwiseQuotient(spacing).array().round().cast<int>()));
            walkedMm = 0.0;
        }
    }
    steady();
}

const VesselLook& LookAlongPath::at(const Eigen::Vector3d& pointMm) const
{
    std::size_t nearest = 0;
    for (std::size_t n = 1; n < placesMm_.size(); ++n) {
        nearest = (placesMm_[n] - pointMm).squaredNorm() < (placesMm_[nearest] - pointMm).squaredNorm() ? n : nearest;
    }
    return looks_[nearest];
}

double LookAlongPath::fill(const Eigen::Vector3d& pointMm) const
{
    const VolumeGeometry& grid = volume_.geometry;
    const double value = interpolated(
        grid, pointMm, [&](const Eigen::Vector3i& at) { return volume_.value(grid.index(at.x(), at.y(), at.z())); });
    const VesselLook& here = at(pointMm);
    return (value - here.tissue) / (here.blood - here.tissue);
}

/// Each look by those around it.
void LookAlongPath::steady()
{
    const std::vector<VesselLook> found = looks_;
    const auto last = static_cast<std::ptrdiff_t>(found.size()) - 1;
    for (std::ptrdiff_t n = 0; n <= last; ++n) {
        std::vector<double> bloods;
        std::vector<double> tissues;
        for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, n - steadyReach); k <= std::min(last, n + steadyReach);
             ++k) {
            bloods.push_back(found[static_cast<std::size_t>(k)].blood);
            tissues.push_back(found[static_cast<std::size_t>(k)].tissue);
        }
        const double tissue = medianOf(tissues);
        looks_[static_cast<std::size_t>(n)] = {std::max(quantile(bloods, bloodRank), tissue + 1.0), tissue};
    }
}

}   // namespace angiopose::core
