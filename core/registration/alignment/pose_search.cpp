#include "core/registration/alignment/pose_search.h"

#include "core/registration/alignment/alignment_points.h"
#include "core/registration/alignment/coarse_search.h"
#include "core/registration/alignment/junction_search.h"
#include "core/registration/alignment/territory_search.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr std::size_t searchPoints = 90;
constexpr std::size_t territoryPoints = 800;
constexpr std::size_t auxiliaryCandidates = 4;

// 3σ of initial poses from DICOM headers (ALGORITHMS §4.4): 15 mm across the ray, 1° per angle and some roll.
const SearchRange nearbyReach{45.0, 8.0, 8.0, 4.0};
constexpr double nearbyClosenessPx = 11.0;
constexpr double anyDistance = 1e9;
const SearchRange wideReach{anyDistance, 30.0, 30.0, 7.5};
const SearchRange territoryReach{60.0, 20.0, 15.0, 5.0};
const SearchRange farthestReach{anyDistance, 90.0, 180.0};
constexpr double wideClosenessPx = 16.0;

std::vector<CentroidPose> posesOf(const std::vector<CoarseCandidate>& candidates, std::size_t count)
{
    std::vector<CentroidPose> poses;
    for (std::size_t k = 0; k < std::min(count, candidates.size()); ++k) {
        poses.push_back(candidates[k].pose);
    }
    return poses;
}

SearchRange within(SearchRange reach, const RegistrationOptions& options, const PoseFreedom& freedom)
{
    reach.freedom = freedom;
    reach.radiusMm = std::min(reach.radiusMm, options.angiopose.searchRadiusMm);
    reach.tiltDeg = std::min(reach.tiltDeg, options.angiopose.searchTiltDeg);
    reach.rollDeg = std::min(reach.rollDeg, options.angiopose.searchRollDeg);
    return reach;
}

/// Returns the values of the points that `alignmentPoints` selects with the same stride.
std::vector<double> takeEveryNth(const std::vector<double>& values, std::size_t stride)
{
    std::vector<double> chosen;
    for (std::size_t i = stride / 2; i < values.size(); i += stride) {
        chosen.push_back(values[i]);
    }
    return chosen;
}

}   // namespace

PoseSearch::PoseSearch(const RegistrationProblem& problem, const TargetLines& target,
                       const RegistrationOptions& options)
    : problem_(problem), target_(target), options_(options)
{
}

std::vector<CentroidPose> PoseSearch::searchNearby(const CentroidPose& start, const SearchObserver& observe) const
{
    const auto points = alignmentPoints(problem_.tree, strideFor(problem_.tree.size(), searchPoints));
    const CoarseSearch search(problem_.camera, target_, nearbyClosenessPx);
    return posesOf(search.find(points, start, within(nearbyReach, options_, problem_.freedom), observe), points.size());
}

std::vector<CentroidPose> PoseSearch::searchWide(const CentroidPose& start, const SearchObserver& observe) const
{
    const auto points = alignmentPoints(problem_.tree, strideFor(problem_.tree.size(), searchPoints));
    const CoarseSearch search(problem_.camera, target_, wideClosenessPx);
    return posesOf(search.find(points, start, within(wideReach, options_, problem_.freedom), observe), points.size());
}

std::vector<CentroidPose> PoseSearch::searchByTerritories(const CentroidPose& start,
                                                          const SearchObserver& observe) const
{
    const std::size_t stride = strideFor(problem_.tree.size(), territoryPoints);
    const auto points = alignmentPoints(problem_.tree, stride);
    TerritorySearch search(problem_.camera, target_, problem_.target.radiusPx);
    return posesOf(search.find(points, takeEveryNth(problem_.tree.radiusMm, stride), start,
                               within(territoryReach, options_, problem_.freedom), observe),
                   points.size());
}

std::vector<CentroidPose> PoseSearch::searchByJunctions(const CentroidPose& start, const SearchObserver& observe) const
{
    const JunctionSearch search(problem_, target_);
    const std::vector<CoarseCandidate> found =
        search.find(start, within(farthestReach, options_, problem_.freedom), observe);
    return posesOf(found, found.size());
}

std::vector<CentroidPose> PoseSearch::searchWithAuxiliary(const CentroidPose& start,
                                                          const SearchObserver& observe) const
{
    std::vector<int> thinned;
    const std::size_t stride = strideFor(problem_.auxiliary.size(), searchPoints);
    for (std::size_t i = 0; i < problem_.auxiliary.size(); i += stride) {
        thinned.push_back(problem_.auxiliary[i]);
    }
    const auto points = alignmentPoints(problem_.tree, thinned);
    const CoarseSearch search(problem_.camera, target_, nearbyClosenessPx);
    return posesOf(search.find(points, start, within(nearbyReach, options_, problem_.freedom), observe),
                   auxiliaryCandidates);
}

CentroidPose PoseSearch::recenterPose(const CentroidPose& start) const
{
    Eigen::Vector2d middlePx = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : problem_.target.points) {
        middlePx += point / static_cast<double>(problem_.target.size());
    }
    CentroidPose moved = start;
    const double depthMm = std::max(minProjectableDepthMm, start.centroidInCamera.z());
    const Eigen::Vector3d ray = rayThroughPixel(problem_.camera, middlePx);
    moved.centroidInCamera = ray * (depthMm / ray.z());
    return problem_.freedom.restoreLockedAxes(moved);
}

}   // namespace angiopose::core
