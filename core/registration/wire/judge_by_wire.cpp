#include "core/registration/wire/judge_by_wire.h"

#include "core/messages/messages.h"
#include "core/registration/judging/distance_metrics.h"
#include "core/registration/judging/pose_shift.h"
#include "core/registration/judging/pose_uncertainty.h"

#include <algorithm>

namespace angiopose::core {
namespace {

// Chosen on synthetic trees (wire_table --world made-up).
constexpr double sureProbability = 0.9;
constexpr double minReportedProbability = 0.05;   // probability of another path
constexpr double minFollowed = 0.7;   // share of the wire
constexpr double maxGaps = 0.2;
constexpr double maxExpectedErrorMm = 2.2;   // errors have an RMS of 0.85 times this; below it, 5 % exceed 3 mm
constexpr double observedShare = 0.5;   // relative to the prior

Quantity percent(double share)
{
    return {100.0 * share, 0, "%"};
}

std::vector<std::string> namesOf(const WirePath& path)
{
    std::vector<std::string> names;
    for (const int id : path.branchIds) {
        names.push_back(std::to_string(id));
    }
    return names;
}

Messages reasonsAgainst(const WireFinding& finding, const RegistrationResult& result)
{
    Messages reasons;
    const WirePath& best = finding.paths.front();
    if (best.probability < sureProbability) {
        if (finding.paths.size() > 1 && finding.paths[1].probability >= minReportedProbability) {
            reasons.push_back(
                messages::wireMayFollow(namesOf(finding.paths[1]), percent(finding.paths[1].probability)));
        } else {
            reasons.push_back(messages::wireUnlikely(percent(best.probability)));
        }
    }
    if (best.followedShare < minFollowed) {
        reasons.push_back(messages::wireOffTree(percent(best.followedShare)));
    }
    if (finding.gapShare > maxGaps) {
        reasons.push_back(messages::wireInPieces(percent(finding.gapShare)));
    }
    if (result.signs.expectedErrorMm > maxExpectedErrorMm) {
        reasons.push_back(messages::trustPoseUncertain(inMm(result.signs.expectedErrorMm, 1)));
    }
    if (result.stopReason == StopReason::StoppedByUser) {
        reasons.push_back(messages::trustStopped());
    }
    return reasons;
}

/// Measures only along the best path: the rest of the tree is not visible.
void measureAlongWay(const RegistrationProblem& problem, const WireFinding& finding, RegistrationResult& result)
{
    if (std::ranges::count(finding.isFollowed, std::uint8_t{1}) == 0) {
        return;
    }
    const RegistrationProblem way = partOf(problem, finding.isFollowed);
    const GridIndex target(problem.target.points);
    result.metrics = distanceMetrics(way, result.cameraFromPatient, projectTree(way, result.cameraFromPatient, target));
}

}   // namespace

void judgeByWire(const RegistrationProblem& problem, const WireFinding& finding, RegistrationResult& result)
{
    result.wirePaths = finding.paths;
    result.camera.reset();
    result.warnings = problem.notes;
    if (finding.paths.empty()) {
        result.trustworthy = false;
        result.warnings.insert(result.warnings.begin(), result.stopReason == StopReason::StoppedByUser
                                                            ? messages::trustStopped()
                                                            : messages::wireNowhere());
        return;
    }
    replaceImageCovariance(result.uncertainty, finding.covariance, problem.tree.spreadMm);
    for (int k = 0; k < 6; ++k) {
        const double std = std::sqrt(std::max(0.0, finding.covariance(k, k)));
        result.uncertainty.observed[static_cast<std::size_t>(k)] = std < observedShare * finding.stdBefore[k];
    }
    result.signs.expectedErrorMm = expectedShiftMm(problem, result.cameraFromPatient, result.uncertainty);
    measureAlongWay(problem, finding, result);
    if (!finding.isAskedFor) {
        result.warnings.push_back(messages::wireFewerWays(std::to_string(finding.paths.size())));
    }
    const Messages reasons = reasonsAgainst(finding, result);
    result.trustworthy = reasons.empty();
    result.warnings.insert(result.warnings.end(), reasons.begin(), reasons.end());
    if (!result.uncertainty.observed[5]) {
        result.warnings.push_back(messages::trustDepthUnknown());
    }
    const WirePath& best = finding.paths.front();
    result.warnings.push_back(
        messages::wireFollows(namesOf(best), percent(best.probability), inMm(best.offAxisMm, 1)).as(Severity::Note));
}

}   // namespace angiopose::core
