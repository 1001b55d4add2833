#include "core/tracing/volume/path/look_along_path.h"

#include "core/imaging/interpolate_grid.h"
#include "core/support/quantile.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace angiopose::core {
namespace {

constexpr double lookEveryMm = 2.0;
constexpr std::ptrdiff_t steadyReach = 7;   // positions averaged on either side; suppresses stents, plaque and gaps
constexpr double bloodRank = 0.75;   // quantile for the lumen level; blurring dims thin segments
constexpr double besideInShells = 1.5;   // in shell radii: distance from the axis at which the surroundings begin
constexpr double clearlyDarker = 0.5;   // minimum drop, fraction of the vessel's contrast; excludes adjacent vessels
constexpr double withinBlood = 0.5;   // fraction of the typical contrast; lower if the shell holds only lumen
constexpr double otherVessel = 0.4;   // minimum drop, fraction of the contrast; excludes blur from other vessels
constexpr double rankBeside = 0.75;   // quantile for the brighter part of the surroundings
constexpr double maxFillBeside = 0.35;
constexpr std::size_t minAround = 6;   // minimum number of samples, out of 26

/// Refines the tissue level from the immediate surroundings of the vessel if enough samples are darker than the vessel;
/// otherwise keeps the level of the wider surroundings. Raises it next to lung or fat, where the rest of the
/// surroundings would otherwise appear half opacified.
VesselLook lookBeside(const PathGround& ground, const Eigen::Vector3i& voxel, VesselLook look)
{
    const double heightOfBlood = look.blood - look.tissue;
    std::vector<double> around;
    std::vector<double> darker;
    for (const double value : ground.valuesAround(voxel, besideInShells * ground.tube(voxel, look.tissue).shellMm)) {
        if (value < look.blood - otherVessel * heightOfBlood) {
            around.push_back(value);
        }
        if (value < look.blood - clearlyDarker * heightOfBlood) {
            darker.push_back(value);
        }
    }
    if (darker.size() >= minAround) {
        look.tissue = medianOf(darker);
    }
    if (around.size() >= minAround) {
        const double brightBeside = quantile(around, rankBeside);
        look.tissue = std::max(look.tissue, (brightBeside - maxFillBeside * look.blood) / (1.0 - maxFillBeside));
    }
    return look;
}

/// Takes the tissue value from the rest of the path if a vessel is so wide that nothing else surrounds its axis.
void lookBeyondBlood(std::vector<VesselLook>& looks)
{
    std::vector<double> heights;
    std::vector<double> tissues;
    for (const VesselLook& look : looks) {
        heights.push_back(look.blood - look.tissue);
        tissues.push_back(look.tissue);
    }
    const double minHeight = withinBlood * medianOf(heights);
    const double tissue = medianOf(tissues);
    for (VesselLook& look : looks) {
        look.tissue = look.blood - look.tissue < minHeight ? std::min(look.tissue, tissue) : look.tissue;
    }
}

}   // namespace

LookAlongPath::LookAlongPath(const PathGround& ground, const std::vector<Eigen::Vector3d>& pointsMm)
    : volume_(ground.volume())
{
    const Eigen::Vector3d& spacing = volume_.geometry.spacingMm;
    std::vector<Eigen::Vector3i> voxels;
    double walkedMm = lookEveryMm;
    for (std::size_t n = 0; n < pointsMm.size(); ++n) {
        walkedMm += n > 0 ? (pointsMm[n] - pointsMm[n - 1]).norm() : 0.0;
        if (walkedMm >= lookEveryMm) {
            placesMm_.push_back(pointsMm[n]);
            voxels.emplace_back(pointsMm[n].cwiseQuotient(spacing).array().round().cast<int>());
            looks_.push_back(ground.lookAt(voxels.back()));
            walkedMm = 0.0;
        }
    }
    lookBeyondBlood(looks_);
    for (std::size_t n = 0; n < voxels.size(); ++n) {
        looks_[n] = lookBeside(ground, voxels[n], looks_[n]);
    }
    steady();
}

std::size_t LookAlongPath::nearest(const Eigen::Vector3d& pointMm) const
{
    std::size_t nearest = 0;
    for (std::size_t n = 1; n < placesMm_.size(); ++n) {
        nearest = (placesMm_[n] - pointMm).squaredNorm() < (placesMm_[nearest] - pointMm).squaredNorm() ? n : nearest;
    }
    return nearest;
}

double LookAlongPath::fill(const Eigen::Vector3d& pointMm) const
{
    return fill(pointMm, looks_[nearest(pointMm)]);
}

double LookAlongPath::fill(const Eigen::Vector3d& pointMm, const VesselLook& look) const
{
    const VolumeGeometry& grid = volume_.geometry;
    const double value = interpolated(
        grid, pointMm, [&](const Eigen::Vector3i& at) { return volume_.value(grid.index(at.x(), at.y(), at.z())); });
    return (value - look.tissue) / (look.blood - look.tissue);
}

BloodFill LookAlongPath::quickFill() const
{
    return [look = *this,
            known = std::unordered_map<std::uint64_t, std::size_t>()](const Eigen::Vector3d& pointMm) mutable {
        const Eigen::Vector3d cell = pointMm.array().floor();
        std::uint64_t key = 0;
        for (const double at : cell) {
            key = key << 21U | (static_cast<std::uint64_t>(static_cast<std::int64_t>(at)) & 0x1FFFFFU);
        }
        const auto [found, isNew] = known.try_emplace(key, 0);
        if (isNew) {
            found->second = look.nearest(cell + Eigen::Vector3d::Constant(0.5));
        }
        return look.fill(pointMm, look.looks_[found->second]);
    };
}

/// Smooths the appearance along the path.
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
