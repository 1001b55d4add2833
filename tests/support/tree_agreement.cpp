#include "tests/support/tree_agreement.h"

#include "core/simulation/stent_wires.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::test {
namespace {

constexpr double stentTipShare = 0.02;   ///< share of the branch length, at both ends of its stent
constexpr double stentReachMm = 2.0;

constexpr double spacingMm = 0.5;

struct Nearest {
    double distanceMm = std::numeric_limits<double>::max();
    double radiusMm = 0.0;
};

Nearest nearestOnTree(const core::VesselTree& tree, const Eigen::Vector3d& point)
{
    Nearest nearest;
    for (const core::VesselBranch& branch : tree.branches) {
        for (std::size_t i = 0; i + 1 < branch.pointsInPatient.size(); ++i) {
            const Eigen::Vector3d& from = branch.pointsInPatient[i];
            const Eigen::Vector3d step = branch.pointsInPatient[i + 1] - from;
            const double share = std::clamp((point - from).dot(step) / std::max(1e-12, step.squaredNorm()), 0.0, 1.0);
            const double distance = (point - from - share * step).norm();
            if (distance < nearest.distanceMm) {
                nearest = {distance, (1.0 - share) * branch.radiusMm[i] + share * branch.radiusMm[i + 1]};
            }
        }
    }
    return nearest;
}

}   // namespace

TreeAgreement agreementOf(const core::VesselTree& traced, const core::VesselTree& truth, double minReachMm)
{
    TreeAgreement result;
    double truePoints = 0.0;
    double foundPoints = 0.0;
    for (const core::VesselBranch& branch : core::resampled(truth, spacingMm).branches) {
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            const double away = nearestOnTree(traced, branch.pointsInPatient[i]).distanceMm;
            foundPoints += away <= std::max(minReachMm, branch.radiusMm[i]) ? 1.0 : 0.0;
            truePoints += 1.0;
        }
    }
    double tracedPoints = 0.0;
    double rightPoints = 0.0;
    for (const core::VesselBranch& branch : core::resampled(traced, spacingMm).branches) {
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            const Nearest nearest = nearestOnTree(truth, branch.pointsInPatient[i]);
            tracedPoints += 1.0;
            if (nearest.distanceMm <= std::max(minReachMm, nearest.radiusMm)) {
                rightPoints += 1.0;
                result.meanDistanceMm += nearest.distanceMm;
                result.radiusError += std::abs(branch.radiusMm[i] - nearest.radiusMm) / nearest.radiusMm;
            }
        }
    }
    result.found = foundPoints / std::max(1.0, truePoints);
    result.right = rightPoints / std::max(1.0, tracedPoints);
    result.overlap = (foundPoints + rightPoints) / std::max(1.0, truePoints + tracedPoints);
    result.meanDistanceMm /= std::max(1.0, rightPoints);
    result.radiusError /= std::max(1.0, rightPoints);
    return result;
}

std::optional<double> radiusErrorInStentMm(const core::VesselTree& traced, const core::VesselBranch& stented)
{
    const core::StentOptions stent;
    const auto count = static_cast<double>(stented.pointsInPatient.size());
    const auto first = static_cast<std::size_t>(std::ceil((stent.startFraction + stentTipShare) * count));
    const auto last = static_cast<std::size_t>(std::floor((stent.endFraction - stentTipShare) * count));
    std::vector<double> errors;
    for (std::size_t n = first; n < last; ++n) {
        double nearestMm = stentReachMm;
        std::optional<double> error;
        for (const core::VesselBranch& branch : traced.branches) {
            for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
                const double awayMm = (branch.pointsInPatient[i] - stented.pointsInPatient[n]).norm();
                if (awayMm < nearestMm) {
                    nearestMm = awayMm;
                    error = branch.radiusMm[i] - stented.radiusMm[n];
                }
            }
        }
        if (error) {
            errors.push_back(*error);
        }
    }
    if (2 * errors.size() < last - first || errors.empty()) {
        return std::nullopt;
    }
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    return *middle;
}

double distanceTo(const core::VesselTree& tree, const Eigen::Vector3d& point)
{
    return nearestOnTree(tree, point).distanceMm;
}

double shareNear(const core::VesselTree& tree, const core::VesselTree& other, double reachMm)
{
    double near = 0.0;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            near += distanceTo(other, point) <= reachMm ? 1.0 : 0.0;
        }
    }
    return near / static_cast<double>(tree.pointCount());
}

}   // namespace angiopose::test
