#include "core/registration/judging/fit_signs.h"

#include "core/registration/alignment/agreement_score.h"
#include "core/registration/alignment/branch_pieces.h"
#include "core/registration/judging/followed_vessels.h"
#include "core/registration/judging/observed_diameter.h"
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

constexpr int maxOfPath = 4;   // branches: a tree with more matched branches is not a single path

/// Whether the matched part of a connected tree has no bifurcation, as with a wire, a catheter or a single vessel.
bool isSinglePath(const PoseInImage& seen)
{
    const BranchPieces parts = branchPieces(seen.problem.tree);
    const auto isSeen = [&seen](const BranchPiece& piece) {
        const double* from = seen.projected.distancePx.data() + piece.from;
        const auto count = static_cast<std::ptrdiff_t>(piece.to - piece.from);
        return 2 * std::count_if(from, from + count, [](double px) { return px <= agreementPx; }) >= count;
    };
    std::vector<int> meeting(static_cast<std::size_t>(parts.junctionCount), 0), seenThere(meeting);
    for (const PieceAtJunction& joint : parts.joints) {
        const auto junction = static_cast<std::size_t>(joint.junction);
        ++meeting[junction];
        seenThere[junction] += isSeen(parts.pieces[static_cast<std::size_t>(joint.piece)]) ? 1 : 0;
    }
    auto components = static_cast<int>(parts.pieces.size());
    for (const int pieces : meeting) {
        components -= std::max(0, pieces - 1);
    }
    return components <= 1 && std::ranges::all_of(seenThere, [](int pieces) { return pieces < 3; });
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
    signs.isPartlyOpacified = std::ranges::count(solution.isOpacified, std::uint8_t{1}) > 0;
    signs.filledForks = solution.filledForks;
    signs.isLumen = isLumen(observedDiameter(seen.problem, seen.target, pose, seen.projected));
    signs.isSinglePath = followed.branchesFollowed <= maxOfPath && isSinglePath(seen);
    return signs;
}

}   // namespace angiopose::core
