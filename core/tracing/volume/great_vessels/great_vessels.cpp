#include "core/tracing/volume/great_vessels/great_vessels.h"

#include "core/support/quantile.h"
#include "core/tracing/volume/great_vessels/necks.h"
#include "core/vessel/polyline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double maxGapInRadii = 2.0;   ///< maximum distance from an end to the other centerline / sum of both radii
constexpr double maxGapIfSame = 2.5;
constexpr double minSlendernessOfTrunks = 5.0;   ///< minimum of one trunk; two heart chambers in a row reach 4.5
constexpr double minLengthMm = 40.0;   ///< minimum length of that trunk; marrow, ureters and dense bowel are shorter
constexpr double minNeckBetween = 0.45;   ///< minimum neck relative to the thinner radius; touching vessels have 0.3
constexpr double maxBeyondSection = 1.3;   ///< inscribed sphere / section; a larger sphere lies in a touching structure
constexpr double maxFillStep = 0.2;   ///< maximum difference within an artery; veins and organs differ more
constexpr double maxStepIfSame = 0.1;   ///< variation of the opacification along a whole aorta
constexpr double minRadiusRatio = 0.5;   ///< thinner / wider radius; below this, one trunk branches off the other
constexpr double minTrunkScoreRatio = 0.01;   ///< score relative to the first trunk; excludes stumps that link trunks

/// Decides whether one trunk continues another.
class TrunkJoiner {
public:
    explicit TrunkJoiner(const DistanceMap& distances)
        : distances_(distances), gridFromPatient_(distances.geometry.patientFromVoxel().inverse())
    {
    }

    bool isContinued(const Trunk& trunk, const Trunk& other) const
    {
        const OpacificationMatch blood = compareOpacification(trunk, other);
        return blood != OpacificationMatch::Other &&
               (isJoinedAt(trunk, 0, other, blood) || isJoinedAt(trunk, trunk.radiusMm.size() - 1, other, blood));
    }

private:
    enum class OpacificationMatch { Same, Similar, Other };

    /// Compares the opacification of two trunks; heart chambers enhance like arteries, so slenderness counts as well.
    static OpacificationMatch compareOpacification(const Trunk& trunk, const Trunk& other)
    {
        const double step = std::abs(trunk.fill - other.fill);
        const bool isSlender = std::max(trunk.slenderness(), other.slenderness()) >= minSlendernessOfTrunks;
        return step > maxFillStep                   ? OpacificationMatch::Other
               : step > maxStepIfSame || !isSlender ? OpacificationMatch::Similar
                                                    : OpacificationMatch::Same;
    }

    /// Returns whether the end of a trunk continues in the other trunk. With equal opacification, the path between them
    /// counts as narrow only relative to the spheres inscribed in the lumen: dissected aortas are flattened, and their
    /// sections are wider than any inscribed sphere.
    bool isJoinedAt(const Trunk& trunk, std::size_t end, const Trunk& other, OpacificationMatch blood) const
    {
        const Eigen::Vector3d& tip = trunk.pointsInPatient[end];
        const std::size_t nearest = nearestTo(tip, other);
        const double radius = trunk.radiusMm[end];
        const double otherRadius = other.radiusMm[nearest];
        double thinner = std::min(radius, otherRadius);
        const double maxGap = blood == OpacificationMatch::Same ? maxGapIfSame : maxGapInRadii;
        if ((other.pointsInPatient[nearest] - tip).norm() > maxGap * (radius + otherRadius) ||
            thinner < minRadiusRatio * std::max(radius, otherRadius)) {
            return false;
        }
        const std::size_t last = nearestOutside(end, trunk, other);
        const std::size_t first = nearestOutside(nearest, other, trunk);
        const Eigen::Vector3i from = centerAt(trunk.pointsInPatient[last], trunk.radiusMm[last]);
        const Eigen::Vector3i to = centerAt(other.pointsInPatient[first], other.radiusMm[first]);
        double thinnerTrunk = std::min(trunk.medianRadiusMm(), other.medianRadiusMm());
        if (blood == OpacificationMatch::Same) {
            thinner = std::min({thinner, sphereRadiusMm(from), sphereRadiusMm(to)});
            thinnerTrunk = std::min({thinnerTrunk, medianSphereRadiusMm(trunk), medianSphereRadiusMm(other)});
        }
        return neckMm(distances_, from, to, std::max(radius, otherRadius)) >=
               minNeckBetween * std::max(thinner, thinnerTrunk);
    }

    static std::size_t nearestTo(const Eigen::Vector3d& place, const Trunk& trunk)
    {
        const auto& points = trunk.pointsInPatient;
        const auto nearest = std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
            return (a - place).squaredNorm() < (b - place).squaredNorm();
        });
        return static_cast<std::size_t>(nearest - points.begin());
    }

    static bool isInside(const Eigen::Vector3d& place, const Trunk& by)
    {
        const std::size_t beside = nearestTo(place, by);
        return (by.pointsInPatient[beside] - place).norm() <= by.radiusMm[beside];
    }

    /// Returns the trunk point nearest to `from` that lies outside the other trunk, or `from` if there is none:
    /// tracking may pass through a wall into a touching structure, where no neck can be detected.
    static std::size_t nearestOutside(std::size_t from, const Trunk& trunk, const Trunk& other)
    {
        const std::size_t count = trunk.pointsInPatient.size();
        for (std::size_t away = 0; away < count; ++away) {
            for (const std::size_t at : {from - std::min(from, away), std::min(from + away, count - 1)}) {
                if (!isInside(trunk.pointsInPatient[at], other)) {
                    return at;
                }
            }
        }
        return from;
    }

    double sphereRadiusMm(const Eigen::Vector3i& voxel) const
    {
        return distances_.mm(distances_.geometry.index(voxel.x(), voxel.y(), voxel.z()));
    }

    double medianSphereRadiusMm(const Trunk& trunk) const
    {
        std::vector<double> balls;
        for (std::size_t n = 0; n < trunk.radiusMm.size(); ++n) {
            balls.push_back(sphereRadiusMm(centerAt(trunk.pointsInPatient[n], trunk.radiusMm[n])));
        }
        return medianOf(std::move(balls));
    }

    /// Returns the center of the surrounding vessel, because the last tracked section may be off-center.
    Eigen::Vector3i centerAt(const Eigen::Vector3d& pointInPatient, double radiusMm) const
    {
        const VolumeGeometry& grid = distances_.geometry;
        const Eigen::Vector3i at =
            (gridFromPatient_ * pointInPatient).array().round().cast<int>().max(0).min(grid.size.array() - 1);
        const auto voxel = static_cast<std::uint32_t>(grid.index(at.x(), at.y(), at.z()));
        const std::uint32_t middle = pathToCenter(voxel, distances_).back();
        return grid.voxelAt(distances_.mm(middle) <= maxBeyondSection * radiusMm ? middle : voxel);
    }

    const DistanceMap& distances_;
    Eigen::Affine3d gridFromPatient_;
};

}   // namespace

Eigen::Vector3d GreatVessel::centerInPatient() const
{
    const std::vector<Eigen::Vector3d>& points = trunks.front().pointsInPatient;
    return points[points.size() / 2];
}

double GreatVessel::score() const
{
    double score = 0.0;   // root sum of squares, so many small branches do not make a great vessel
    for (const Trunk& trunk : trunks) {
        score = std::hypot(score, trunk.score());
    }
    return score;
}

bool GreatVessel::surrounds(const Eigen::Vector3d& positionInPatient) const
{
    return std::any_of(trunks.begin(), trunks.end(), [&](const Trunk& trunk) {
        for (std::size_t n = 0; n < trunk.radiusMm.size(); ++n) {
            if ((trunk.pointsInPatient[n] - positionInPatient).norm() < trunk.radiusMm[n]) {
                return true;
            }
        }
        return false;
    });
}

std::vector<GreatVessel> assembleGreatVessels(const BlockOpacification& blood, int threads, TracingProgress& progress)
{
    const DistanceMap distances = distanceMap(blood.lumen, threads, progress);
    std::vector<Trunk> remaining = findTrunks(blood, distances, progress);
    const TrunkJoiner trunkJoiner(distances);
    std::vector<GreatVessel> vessels;
    while (!remaining.empty()) {
        GreatVessel vessel{{remaining.front()}};
        remaining.erase(remaining.begin());
        for (std::size_t t = 0; t < remaining.size() && progress.advance(0.0);) {
            const bool isRelevant = remaining[t].score() >= minTrunkScoreRatio * vessel.trunks.front().score();
            const bool isJoined =
                isRelevant && std::any_of(vessel.trunks.begin(), vessel.trunks.end(), [&](const Trunk& trunk) {
                    return trunkJoiner.isContinued(remaining[t], trunk) || trunkJoiner.isContinued(trunk, remaining[t]);
                });
            if (isJoined) {
                vessel.trunks.push_back(remaining[t]);
                remaining.erase(remaining.begin() + static_cast<std::ptrdiff_t>(t));
                t = 0;   // trunks rejected before may continue this one
            } else {
                ++t;
            }
        }
        vessels.push_back(std::move(vessel));
    }
    std::erase_if(vessels, [](const GreatVessel& vessel) {
        return std::none_of(vessel.trunks.begin(), vessel.trunks.end(), [](const Trunk& trunk) {
            return trunk.slenderness() >= minSlendernessOfTrunks &&
                   polylineLength<3>(trunk.pointsInPatient) >= minLengthMm;
        });
    });
    std::stable_sort(vessels.begin(), vessels.end(),
                     [](const GreatVessel& a, const GreatVessel& b) { return a.score() > b.score(); });
    return vessels;
}

}   // namespace angiopose::core
