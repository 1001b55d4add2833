#include "core/registration/wire/wire_report.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace angiopose::core {
namespace {

constexpr double minFollowedMm = 3.0;   // minimum length of wire in a listed branch
constexpr double minFollowedShare = 0.2;   // minimum fraction of the wire that follows a reported path
constexpr double minProbability = 0.01;
constexpr std::size_t maxPaths = 9;
constexpr double minOverlap = 0.85;   // minimum overlap of two paths that are reported as one
constexpr double temperature =
    0.8;   // softmax temperature that calibrates the evidence to hit rates (wire_table --world made-up)

/// Returns the fraction of the longer course that it shares with the other.
double overlapShare(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b)
{
    std::vector<std::size_t> shared;
    std::ranges::set_intersection(a, b, std::back_inserter(shared));
    return static_cast<double>(shared.size()) / static_cast<double>(std::max(a.size(), b.size()));
}

}   // namespace

WireReport::WireReport(const RegistrationProblem& problem, const VesselTree& tree, const WireProblem& wire,
                       const WireModel& model, double mmPerPx)
    : problem_(problem), tree_(tree), wire_(wire), model_(model), mmPerPx_(mmPerPx)
{
}

/// Returns the branches in order along the wire, without those that the wire barely enters.
std::vector<int> WireReport::branchesOf(const WireFit& fit) const
{
    std::vector<int> ids;
    std::size_t first = fit.alignment.pairs.front().knot;
    for (std::size_t j = first; j <= fit.alignment.pairs.back().knot; ++j) {
        const bool isLast = j == fit.alignment.pairs.back().knot;
        const std::size_t branch = wire_.knots.branchOf(fit.way.knots[j]);
        if (isLast || wire_.knots.branchOf(fit.way.knots[j + 1]) != branch) {
            if (static_cast<double>(j - first) * wireKnotSpacingMm >= minFollowedMm || (isLast && ids.empty())) {
                ids.push_back(tree_.branches[branch].id);
            }
            first = j + 1;
        }
    }
    return ids;
}

WirePath WireReport::pathOf(const WireFit& fit) const
{
    WirePath path;
    path.branchIds = branchesOf(fit);
    const std::size_t first = fit.way.knots[fit.alignment.pairs.front().knot];
    const std::size_t last = fit.way.knots[fit.alignment.pairs.back().knot];
    // Wires advance from wide vessels into narrow ones.
    const bool isBackwards = wire_.knots.radiusMm[last] > wire_.knots.radiusMm[first];
    path.tipInPatient = wire_.knots.positions[isBackwards ? first : last];
    for (std::size_t j = fit.alignment.pairs.front().knot; j <= fit.alignment.pairs.back().knot; ++j) {
        path.courseInPatient.push_back(wire_.knots.positions[fit.way.knots[j]]);
    }
    if (isBackwards) {
        std::ranges::reverse(path.branchIds);
        std::ranges::reverse(path.courseInPatient);
    }
    path.cameraFromPatient = cameraFromPatient(fit.pose, wire_.centroid);
    path.followedShare = fit.alignment.followedPx(wire_.curve) / std::max(1e-9, wire_.curve.lengthPx());
    const ProjectedKnots projected = wire_.projected(fit.way.knots, fit.pose);
    double squares = 0.0;
    double count = 0.0;
    for (const WirePair& pair : fit.alignment.pairs) {
        const Eigen::Vector2d offPx = projected.pixels[pair.knot] - wire_.curveOf(fit.way).pointsPx[pair.point];
        squares += pair.lengthMm * offPx.squaredNorm() * projected.mmPerPx * projected.mmPerPx;
        count += pair.lengthMm;
    }
    path.offAxisMm = count > 0.0 ? std::sqrt(squares / count) : 0.0;
    return path;
}

/// Merges paths that the image cannot distinguish: of the fits with the same branches, keeps the most likely one; of
/// the paths with nearly the same visible course, reports the most likely one and collects the evidence of all.
std::vector<WireReport::ReportedPath> WireReport::reportedPaths(const std::vector<WireFit>& fits) const
{
    std::vector<ReportedPath> reported;
    std::vector<std::vector<int>> known;
    for (const WireFit& fit : fits) {
        if (fit.alignment.followedPx(wire_.curve) < minFollowedShare * wire_.curve.lengthPx()) {
            continue;
        }
        WirePath path = pathOf(fit);
        std::vector<int> branches = path.branchIds;
        std::ranges::sort(branches);
        if (std::ranges::count(known, branches) > 0) {
            continue;
        }
        known.push_back(std::move(branches));
        std::vector<std::size_t> course = courseOf(fit);
        const auto same = std::ranges::find_if(
            reported, [&](const ReportedPath& other) { return overlapShare(other.course, course) >= minOverlap; });
        if (same != reported.end()) {
            same->logEvidences.push_back(fit.logEvidence);
        } else {
            reported.push_back({std::move(path), &fit, std::move(course), {fit.logEvidence}});
        }
    }
    return reported;
}

WireResult WireReport::makeResult(const std::vector<WireFit>& fits, std::size_t pathRank) const
{
    WireResult result;
    result.gapFraction = wire_.curve.gapFraction;
    result.initialStd = wire_.prior.std();
    std::vector<ReportedPath> reported = reportedPaths(fits);
    if (!reported.empty()) {
        assignProbabilities(reported);
        std::erase_if(reported, [&](const ReportedPath& way) {
            return way.path.probability < minProbability && &way != &reported.front();
        });
        reported.resize(std::min(reported.size(), maxPaths));
        result.hasRequestedPath = pathRank <= reported.size();
        if (result.hasRequestedPath) {
            const auto wanted = reported.begin() + static_cast<std::ptrdiff_t>(pathRank) - 1;
            std::rotate(reported.begin(), wanted, wanted + 1);
        }
        result.covariance = totalCovariance(reported);
        result.isFollowed = pointsOnPath(*reported.front().fit);
        for (ReportedPath& way : reported) {
            result.paths.push_back(std::move(way.path));
        }
    }
    return result;
}

/// Returns the knots along the wire, sorted.
std::vector<std::size_t> WireReport::courseOf(const WireFit& fit) const
{
    const auto knot = [&](std::size_t place) { return fit.way.knots.begin() + static_cast<std::ptrdiff_t>(place); };
    std::vector<std::size_t> course(knot(fit.alignment.pairs.front().knot), knot(fit.alignment.pairs.back().knot + 1));
    std::ranges::sort(course);
    return course;
}

std::vector<std::uint8_t> WireReport::pointsOnPath(const WireFit& fit) const
{
    std::vector<std::uint8_t> isFollowed(problem_.tree.size(), 0);
    for (std::size_t i = 0; i < isFollowed.size(); ++i) {
        for (std::size_t j = fit.alignment.pairs.front().knot; j <= fit.alignment.pairs.back().knot; ++j) {
            const double offMm = (wire_.knots.positions[fit.way.knots[j]] - problem_.tree.points[i]).norm();
            isFollowed[i] = offMm < wireKnotSpacingMm ? 1 : isFollowed[i];
        }
    }
    return isFollowed;
}

/// Assigns probabilities by evidence, including the possibility that the wire follows none of the paths; sorts the most
/// likely first.
void WireReport::assignProbabilities(std::vector<ReportedPath>& reported) const
{
    const double best = reported.front().fit->logEvidence;
    const auto weight = [&](double logEvidence) { return std::exp((logEvidence - best) / temperature); };
    double sum = weight(-model_.skipPerMm * wire_.curve.lengthPx() * mmPerPx_);
    for (ReportedPath& way : reported) {
        for (const double logEvidence : way.logEvidences) {
            way.path.probability += weight(logEvidence);
        }
        sum += way.path.probability;
    }
    for (ReportedPath& way : reported) {
        way.path.probability /= sum;
    }
    std::ranges::stable_sort(reported, std::ranges::greater(),
                             [](const ReportedPath& way) { return way.path.probability; });
}

/// Returns the total covariance of the first path's pose about the tree centroid: within-path plus between-path.
Matrix6d WireReport::totalCovariance(const std::vector<ReportedPath>& reported) const
{
    const CentroidPose& best = reported.front().fit->pose;
    Matrix6d covariance = Matrix6d::Zero();
    double sum = 0.0;
    for (const ReportedPath& way : reported) {
        const Vector6d step = stepBetween(best, way.fit->pose);
        covariance += way.path.probability * (way.fit->covariance + step * step.transpose());
        sum += way.path.probability;
    }
    Matrix6d carry = Matrix6d::Identity();
    carry.bottomLeftCorner<3, 3>() = -skew(best.rotation * (problem_.wholeTreeCentroid - wire_.centroid));
    return carry * (covariance / sum) * carry.transpose();
}

}   // namespace angiopose::core
