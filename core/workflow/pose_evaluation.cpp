#include "core/workflow/pose_evaluation.h"

#include "core/evaluation/trial/branch_distances.h"
#include "core/registration/judging/unopacified_branches.h"
#include "core/support/quantile.h"

#include <algorithm>

namespace angiopose::core {
namespace {

std::vector<double> allDistances(const std::map<int, std::vector<double>>& residualPx)
{
    std::vector<double> all;
    for (const auto& [branchId, distancesPx] : residualPx) {
        all.insert(all.end(), distancesPx.begin(), distancesPx.end());
    }
    return all;
}

}   // namespace

double medianOf(const std::map<int, std::vector<double>>& residualPx)
{
    std::vector<double> all = allDistances(residualPx);
    return all.empty() ? 0.0 : quantile(all, 0.5);
}

std::optional<FitBasis> fitBasis(const Case& session, const RegistrationResult& result,
                                 const std::map<int, std::vector<double>>& residualPx)
{
    const View& view = session.shown();
    const auto camera = cameraOf(view);
    std::vector<double> all = allDistances(residualPx);
    if (!camera || all.empty() || !session.vessels.tree) {
        return std::nullopt;
    }
    const double depthMm = (view.cameraFromPatient * centroidInPatient(*session.vessels.tree)).z();
    const double mmPerPx = millimetersPerPixel(camera.value(), std::max(depthMm, minProjectableDepthMm));
    FitBasis basis{assessedFraction(result), mmPerPx * quantile(all, 0.5), mmPerPx * quantile(all, 0.95), {}, {}};
    const auto mediansOf = [&](const std::vector<int>& branchIds) {
        std::vector<std::pair<int, double>> mediansMm;
        for (const int branchId : branchIds) {
            if (const auto found = residualPx.find(branchId); found != residualPx.end() && !found->second.empty()) {
                std::vector<double> own = found->second;
                mediansMm.emplace_back(branchId, mmPerPx * quantile(own, 0.5));
            }
        }
        return mediansMm;
    };
    basis.excludedMm = mediansOf(session.vessels.excludedBranchIds);
    basis.auxiliaryMm = mediansOf(session.vessels.auxiliaryBranchIds);
    return basis;
}

std::optional<FitBasis> fitBasis(const Case& session, const RegistrationResult& result, const Centerline2d& target)
{
    const auto camera = cameraOf(session.shown());
    return camera && session.vessels.tree ? fitBasis(session, result,
                                                     branchDistances(*session.vessels.tree, target, camera.value(),
                                                                     session.shown().cameraFromPatient))
                                          : std::nullopt;
}

Result<PoseEvaluation> evaluateWithResiduals(const RegistrationInput& input, const RigidTransform& cameraFromPatient)
{
    auto result = evaluatePose(input, cameraFromPatient);
    if (!result) {
        return result.error();
    }
    return PoseEvaluation{std::move(result).value(),
                          branchDistances(input.tree, input.target, input.camera, cameraFromPatient)};
}

}   // namespace angiopose::core
