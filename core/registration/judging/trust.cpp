#include "core/registration/judging/trust.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

// Measured on simulated angiograms through the real tracing, for several methods (ALGORITHMS §4.4): what separates
// poses within 2 mm from others.
constexpr double minAgreement = 0.37;   // harmonic mean of the shares of tree and vessels that explain each other
constexpr double maxSettlingMm = 1.3;
constexpr double maxExpectedErrorMm = 1.2;
constexpr double maxRivalMm = 2.0;   // nearer alternatives change nothing for the user
constexpr double minInView = 0.4;   // of the tree's points
// Wrong poses follow up to 0.3 of the tree inside the image, right ones of trees that the image cuts off 0.47 and more.
constexpr double convincingShare = 0.4;
constexpr int convincingBranches = 4;
constexpr double maxRotationStdDeg = 3.0;
constexpr double maxInPlaneStdMm = 3.0;

std::string percent(double share)
{
    return std::to_string(std::lround(100.0 * share)) + " %";
}

std::string millimetres(double length)
{
    const auto tenths = std::lround(10.0 * length);
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " mm";
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

/// What the image shows of the tree runs along traced vessels, however much lies outside.
bool followsVessels(const Evidence& evidence)
{
    const FollowedVessels followed =
        followedVessels(evidence.problem, evidence.target, evidence.result.cameraFromPatient, evidence.projected);
    return followed.share() >= convincingShare && followed.branchesFollowed >= convincingBranches;
}

void judgeFit(const Evidence& evidence, std::vector<std::string>& reasons)
{
    const double inView = shareOf(evidence.projected.isInView);
    const bool isDoubtful = inView < minInView || evidence.agreement < minAgreement;
    if (isDoubtful && !followsVessels(evidence)) {
        if (inView < minInView) {
            reasons.push_back("Only " + percent(inView) + " of the vessel tree lies inside the image.");
        }
        if (evidence.agreement < minAgreement) {
            reasons.push_back("Only " + percent(agreeingShare(evidence.projected)) +
                              " of the vessel tree lies on a traced vessel, and it explains " +
                              percent(evidence.result.metrics.coverage) + " of the traced vessels.");
        }
    }
    if (evidence.settlingMm > maxSettlingMm) {
        reasons.push_back("The vessels fit better " + millimetres(evidence.settlingMm) + " aside.");
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
    if (evidence.expectedErrorMm > maxExpectedErrorMm) {
        trust.warnings.push_back("The image leaves the pose uncertain by about " +
                                 millimetres(evidence.expectedErrorMm) + ".");
    }
    if (evidence.rivalMm > maxRivalMm) {
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

}   // namespace angiopose::core