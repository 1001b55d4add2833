#include "core/registration/trust.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

constexpr double minTreeShare = 0.5;   // of the tree's points in view, along traced vessels
constexpr double minCoverage = 0.35;   // of the traced vessels, explained by the tree
constexpr double minInView = 0.4;   // of the tree's points
constexpr double wellExplained = 0.8;   // of the traced vessels: then many branches may simply be unfilled
constexpr double unfilledAllowance = 0.6;   // what the shares of the tree are multiplied by in that case
constexpr double branchAgrees = 0.5;
constexpr double minBranchShare = 0.4;
constexpr double maxRotationStdDeg = 3.0;
constexpr double maxInPlaneStdMm = 3.0;

std::string percent(double share)
{
    return std::to_string(std::lround(100.0 * share)) + " %";
}

double shareOf(const std::vector<std::uint8_t>& flags)
{
    return static_cast<double>(std::count(flags.begin(), flags.end(), 1)) / static_cast<double>(flags.size());
}

/// Share of all tree points that lie along traced vessels.
double agreeingShare(const ProjectedTree& projected)
{
    const auto agreeing = std::count_if(projected.distancePx.begin(), projected.distancePx.end(),
                                        [](double distance) { return distance <= agreementPx; });
    return static_cast<double>(agreeing) / static_cast<double>(projected.distancePx.size());
}

void judgeFit(const Evidence& evidence, std::vector<std::string>& reasons)
{
    const double inView = shareOf(evidence.projected.isInView);
    if (inView < minInView) {
        reasons.push_back("Only " + percent(inView) + " of the vessel tree lies inside the image.");
    }
    const double demand = evidence.result.metrics.coverage >= wellExplained ? unfilledAllowance : 1.0;
    const double agreeing = agreeingShare(evidence.projected);
    if (agreeing < demand * minTreeShare) {
        reasons.push_back("Only " + percent(agreeing) + " of the vessel tree lies on a traced vessel.");
    }
    if (evidence.result.metrics.coverage < minCoverage) {
        reasons.push_back("The tree explains only " + percent(evidence.result.metrics.coverage) +
                          " of the traced vessels.");
    }
    const auto& branches = evidence.result.branches;
    const auto good = std::count_if(branches.begin(), branches.end(),
                                    [](const BranchResidual& branch) { return branch.agreement >= branchAgrees; });
    if (static_cast<double>(good) < demand * minBranchShare * static_cast<double>(branches.size())) {
        reasons.push_back("Only " + std::to_string(good) + " of " + std::to_string(branches.size()) +
                          " branches agree with the image.");
    }
}

void judgeUncertainty(const PoseUncertainty& uncertainty, std::vector<std::string>& reasons)
{
    const auto& observed = uncertainty.observed;
    if (!observed[0] || !observed[1] || uncertainty.rotationDeg.head<2>().maxCoeff() > maxRotationStdDeg) {
        reasons.emplace_back("The image hardly tells how the vessels are tilted out of the image plane.");
    }
    if (!observed[2] || uncertainty.rotationDeg.z() > maxRotationStdDeg) {
        reasons.emplace_back("The image hardly tells how the vessels are turned in the image plane.");
    }
    if (!observed[3] || !observed[4] || uncertainty.inPlaneMm > maxInPlaneStdMm) {
        reasons.emplace_back("The image hardly tells where along the vessels the tree lies.");
    }
}

}   // namespace

Trust judgeTrust(const Evidence& evidence)
{
    Trust trust;
    judgeFit(evidence, trust.warnings);
    judgeUncertainty(evidence.result.uncertainty, trust.warnings);
    if (!evidence.result.alternatives.empty()) {
        trust.warnings.emplace_back("Another pose explains the image nearly as well: compare the alternatives.");
    }
    if (evidence.result.stopReason == StopReason::StoppedByUser) {
        trust.warnings.emplace_back("The registration was stopped before its end.");
    }
    trust.isTrustworthy = trust.warnings.empty();
    if (!evidence.result.uncertainty.observed[5]) {
        trust.warnings.emplace_back(
            "One view does not tell the depth here: the distance from the source stays close to the start pose.");
    }
    return trust;
}

}   // namespace core
