#include "core/registration/judging/mismatched_branches.h"

#include "core/registration/deformable/deform_vessels.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double disagreeingMm = 1.0;
constexpr double minMatchedShare = 0.5;   ///< minimum matched fraction of a branch's length

bool isReportedUnopacified(const RegistrationResult& result, int branchId)
{
    return std::ranges::find(result.unopacified, branchId, &UnopacifiedBranch::branchId) != result.unopacified.end();
}

/// Whether the vessels are deformed and the image shows this branch at its deformed position.
bool isExplainedByDeformation(const RegistrationResult& result, int branchId)
{
    if (!result.deformed || result.deformed->verdict != DeformationVerdict::Deformed) {
        return false;
    }
    return std::ranges::any_of(result.deformed->branches, [branchId](const BranchMotion& motion) {
        return motion.branchId == branchId && motion.seenShare >= minMatchedShare;
    });
}

/// Whether this branch is not expected in the image because a wire follows other branches.
bool isOffWirePath(const RegistrationResult& result, int branchId)
{
    return !result.wirePaths.empty() && std::ranges::count(result.wirePaths.front().branchIds, branchId) == 0;
}

}   // namespace

MismatchedBranches mismatchedBranches(const RegistrationResult& result, double millimetersPerPixel)
{
    MismatchedBranches found;
    for (const BranchResidual& residual : result.branches) {
        const double medianMm = residual.medianPx * millimetersPerPixel;
        const int id = residual.branchId;
        if (medianMm > disagreeingMm && !isReportedUnopacified(result, id) && !isExplainedByDeformation(result, id) &&
            !isOffWirePath(result, id)) {
            found.branchIds.push_back(id);
            found.maxDistanceMm = std::max(found.maxDistanceMm, medianMm);
        }
    }
    return found;
}

}   // namespace angiopose::core
