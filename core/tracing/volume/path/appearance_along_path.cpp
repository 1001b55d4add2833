#include "core/tracing/volume/path/appearance_along_path.h"

#include "core/imaging/interpolate_grid.h"
#include "core/support/quantile.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace angiopose::core {
namespace {

constexpr double sampleSpacingMm = 2.0;
constexpr std::ptrdiff_t smoothingReach = 7;   // positions averaged on either side; suppresses stents, plaque and gaps
constexpr double bloodQuantile = 0.75;   // quantile for the lumen level; blurring dims thin segments
constexpr double nearbyInShells = 1.5;   // in shell radii: distance from the centerline at which the surroundings begin
constexpr double minClearDrop = 0.5;   // minimum drop, fraction of the vessel's contrast; excludes adjacent vessels
constexpr double minRelativeContrast = 0.5;   // fraction of the typical contrast; lower if the shell holds only lumen
constexpr double minDropToVessel = 0.4;   // minimum drop, fraction of the contrast; excludes blur from other vessels
constexpr double surroundingsQuantile = 0.75;   // quantile for the brighter part of the surroundings
constexpr double maxFillNearby = 0.35;
constexpr std::size_t minSamples = 6;   // minimum number of samples, out of 26

/// Refines the tissue level from the immediate surroundings of the vessel if enough samples are darker than the vessel;
/// otherwise keeps the level of the wider surroundings. Raises it next to lung or fat, where the rest of the
/// surroundings would otherwise appear half opacified.
VesselAppearance refineTissueLevel(const TubeDetector& detector, const Eigen::Vector3i& voxel,
                                   VesselAppearance appearance)
{
    const double contrast = appearance.blood - appearance.tissue;
    std::vector<double> around;
    std::vector<double> darker;
    for (const double value :
         detector.valuesAround(voxel, nearbyInShells * detector.tube(voxel, appearance.tissue).shellMm)) {
        if (value < appearance.blood - minDropToVessel * contrast) {
            around.push_back(value);
        }
        if (value < appearance.blood - minClearDrop * contrast) {
            darker.push_back(value);
        }
    }
    if (darker.size() >= minSamples) {
        appearance.tissue = medianOf(darker);
    }
    if (around.size() >= minSamples) {
        const double brightNearby = quantile(around, surroundingsQuantile);
        appearance.tissue =
            std::max(appearance.tissue, (brightNearby - maxFillNearby * appearance.blood) / (1.0 - maxFillNearby));
    }
    return appearance;
}

/// Takes the tissue value from the rest of the path if a vessel is so wide that nothing else surrounds its centerline.
void correctWideSections(std::vector<VesselAppearance>& appearances)
{
    std::vector<double> contrasts;
    std::vector<double> tissues;
    for (const VesselAppearance& appearance : appearances) {
        contrasts.push_back(appearance.blood - appearance.tissue);
        tissues.push_back(appearance.tissue);
    }
    const double minContrast = minRelativeContrast * medianOf(contrasts);
    const double tissue = medianOf(tissues);
    for (VesselAppearance& appearance : appearances) {
        appearance.tissue = appearance.blood - appearance.tissue < minContrast ? std::min(appearance.tissue, tissue)
                                                                               : appearance.tissue;
    }
}

}   // namespace

AppearanceAlongPath::AppearanceAlongPath(const TubeDetector& detector, const std::vector<Eigen::Vector3d>& pointsMm)
    : volume_(detector.volume())
{
    const Eigen::Vector3d& spacing = volume_.geometry.spacingMm;
    std::vector<Eigen::Vector3i> voxels;
    double sinceLastMm = sampleSpacingMm;
    for (std::size_t n = 0; n < pointsMm.size(); ++n) {
        sinceLastMm += n > 0 ? (pointsMm[n] - pointsMm[n - 1]).norm() : 0.0;
        if (sinceLastMm >= sampleSpacingMm) {
            samplesMm_.push_back(pointsMm[n]);
            voxels.emplace_back(pointsMm[n].cwiseQuotient(spacing).array().round().cast<int>());
            appearances_.push_back(detector.appearanceAt(voxels.back()));
            sinceLastMm = 0.0;
        }
    }
    correctWideSections(appearances_);
    for (std::size_t n = 0; n < voxels.size(); ++n) {
        appearances_[n] = refineTissueLevel(detector, voxels[n], appearances_[n]);
    }
    smoothAlongPath();
}

std::size_t AppearanceAlongPath::nearest(const Eigen::Vector3d& pointMm) const
{
    std::size_t nearest = 0;
    for (std::size_t n = 1; n < samplesMm_.size(); ++n) {
        nearest = (samplesMm_[n] - pointMm).squaredNorm() < (samplesMm_[nearest] - pointMm).squaredNorm() ? n : nearest;
    }
    return nearest;
}

double AppearanceAlongPath::opacification(const Eigen::Vector3d& pointMm) const
{
    return opacification(pointMm, appearances_[nearest(pointMm)]);
}

double AppearanceAlongPath::opacification(const Eigen::Vector3d& pointMm, const VesselAppearance& appearance) const
{
    const VolumeGeometry& grid = volume_.geometry;
    const double value = interpolateTrilinear(
        grid, pointMm, [&](const Eigen::Vector3i& at) { return volume_.value(grid.index(at.x(), at.y(), at.z())); });
    return (value - appearance.tissue) / (appearance.blood - appearance.tissue);
}

PointOpacification AppearanceAlongPath::cachedOpacification() const
{
    return [appearance = *this,
            known = std::unordered_map<std::uint64_t, std::size_t>()](const Eigen::Vector3d& pointMm) mutable {
        const Eigen::Vector3d cell = pointMm.array().floor();
        std::uint64_t key = 0;
        for (const double at : cell) {
            key = key << 21U | (static_cast<std::uint64_t>(static_cast<std::int64_t>(at)) & 0x1FFFFFU);
        }
        const auto [unsmoothed, isNew] = known.try_emplace(key, 0);
        if (isNew) {
            unsmoothed->second = appearance.nearest(cell + Eigen::Vector3d::Constant(0.5));
        }
        return appearance.opacification(pointMm, appearance.appearances_[unsmoothed->second]);
    };
}

/// Smooths the appearance along the path.
void AppearanceAlongPath::smoothAlongPath()
{
    const std::vector<VesselAppearance> unsmoothed = appearances_;
    const auto last = static_cast<std::ptrdiff_t>(unsmoothed.size()) - 1;
    for (std::ptrdiff_t n = 0; n <= last; ++n) {
        std::vector<double> bloods;
        std::vector<double> tissues;
        for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, n - smoothingReach);
             k <= std::min(last, n + smoothingReach); ++k) {
            bloods.push_back(unsmoothed[static_cast<std::size_t>(k)].blood);
            tissues.push_back(unsmoothed[static_cast<std::size_t>(k)].tissue);
        }
        const double tissue = medianOf(tissues);
        appearances_[static_cast<std::size_t>(n)] = {std::max(quantile(bloods, bloodQuantile), tissue + 1.0), tissue};
    }
}

}   // namespace angiopose::core
