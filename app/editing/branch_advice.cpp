#include "app/editing/branch_advice.h"

#include "core/registration/pose/initial_pose_prior.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace angiopose::app {
namespace {

constexpr int branchesPerStep = 2;   ///< number of branches named for each pose component

core::Vector6d inDegrees(core::Vector6d std)
{
    std.head<3>() *= 180.0 / std::numbers::pi;
    return std;
}

/// Derives the advice. `chosen` are the auxiliary branches; `priorStd` is the solver's prior standard deviation of an
/// initial pose.
BranchAdvice adviceFrom(const std::vector<core::BranchInformation>& branches, const std::vector<int>& auxiliary,
                        const core::Vector6d& priorStd)
{
    std::vector<int> all(branches.size());
    std::ranges::transform(branches, all.begin(), &core::BranchInformation::branchId);
    BranchAdvice advice;
    advice.stdAllBranches = inDegrees(core::expectedStd(branches, all, priorStd));
    advice.stdAuxiliary = inDegrees(core::expectedStd(branches, auxiliary.empty() ? all : auxiliary, priorStd));
    for (std::size_t step = 0; step < advice.constrainedBy.size(); ++step) {
        advice.constrainedBy[step] =
            core::bestBranchesForComponent(branches, static_cast<int>(step), priorStd, branchesPerStep);
    }
    advice.suggestedIds = core::informativeBranchSet(branches, priorStd);
    return advice;
}

}   // namespace

BranchAdviser::BranchAdviser(const CaseDocument& document, QObject* parent)
    : QObject(parent), document_(document), job_([this](const BranchAdvice& advice) { setAdvice(advice); })
{
}

void BranchAdviser::requestAdvice()
{
    if (job_.isRunning()) {
        isRestartPending_ = true;
    } else {
        start();
    }
}

void BranchAdviser::start()
{
    const core::Case& current = document_.current();
    const auto camera = core::cameraOf(current.shown());
    if (!current.vessels.tree || !camera) {
        advice_.reset();
        return;
    }
    job_.start([tree = current.vessels.tree, camera = camera.value(), pose = current.shown().cameraFromPatient,
                excluded = current.vessels.excludedBranchIds, auxiliary = current.vessels.auxiliaryBranchIds,
                priorStd = core::Vector6d(core::initialPosePrior({}, current.options).std())](
                   JobLink<double>&) -> core::Result<BranchAdvice> {
        return adviceFrom(core::branchInformation(core::withoutBranches(*tree, excluded), camera, pose), auxiliary,
                          priorStd);
    });
}

void BranchAdviser::setAdvice(const BranchAdvice& advice)
{
    advice_ = advice;
    if (std::exchange(isRestartPending_, false)) {
        start();
    }
    emit adviceReady();
}

}   // namespace angiopose::app
