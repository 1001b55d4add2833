#include "core/registration/judging/fit_signs.h"

#include "core/registration/alignment/agreement_score.h"
#include "core/registration/judging/followed_vessels.h"
#include "core/registration/judging/pose_shift.h"

#include <algorithm>

namespace angiopose::core {
namespace {

template <class Value, class Predicate>
double shareOf(const std::vector<Value>& values, const Predicate& holds)
{
    return static_cast<double>(std::ranges::count_if(values, holds)) / static_cast<double>(values.size());
}

double agreementOf(const PoseInImage& seen, const RigidTransform& pose)
{
    return AgreementScore(seen.problem, seen.target).of(aboutCentroid(pose, seen.problem.tree.centroid));
}

}   // namespace

FitSigns fitSigns(const PoseInImage& seen, const RegistrationOptions& options, const MethodSolution& solution)
{
    const RigidTransform& pose = solution.cameraFromPatient;
    const FollowedVessels followed = followedVessels(seen.problem, seen.target, pose, seen.projected);
    FitSigns signs;
    signs.agreement = solution.agreement ? *solution.agreement : agreementOf(seen, pose);
    signs.treeShare = shareOf(seen.projected.distancePx, [](double distance) { return distance <= agreementPx; });
    signs.inViewShare = shareOf(seen.projected.isInView, [](std::uint8_t isInView) { return isInView != 0; });
    signs.followedShare = followed.share();
    signs.followedMm = followed.followedMm;
    signs.followedBranches = followed.branchesFollowed;
    signs.settlingMm = solution.isSettled ? 0.0 : settlingShiftMm(seen.problem, seen.target, pose, options);
    signs.expectedErrorMm = expectedShiftMm(seen.problem, pose, seen.uncertainty);
    for (const Hypothesis& other : solution.alternatives) {
        signs.rivalMm = std::max(signs.rivalMm, meanShiftMm(seen.problem.tree, pose, other.cameraFromPatient));
    }
    signs.isFilledInParts = std::ranges::count(solution.isFilled, std::uint8_t{1}) > 0;
    signs.filledForks = solution.filledForks;
    return signs;
}

}   // namespace angiopose::core
