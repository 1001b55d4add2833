#pragma once

#include "core/case/case.h"

#include <map>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Agreement of a pose with the image, overall and at every point of the tree.
struct PoseJudgement {
    RegistrationResult result;   ///< from evaluatePose
    std::map<int, std::vector<double>> residualPx;   ///< per branch id, one value per tree point, see branchDistances
};

/// Branches included in, and excluded from, the distances of a result.
struct FitBasis {
    double judgedShare = 1.0;   ///< share of the tree, 0…1; the rest is considered unopacified
    double wholeMedianMm = 0.0,
           wholeP95Mm = 0.0;   ///< over every point of the tree, including excluded and unopacified ones
    std::vector<std::pair<int, double>> excludedMm, auxiliaryMm;   ///< branches and their medians
};

/// Returns the basis of `result` for the shown view, whose distances are `residualPx` (see branchDistances); nothing if
/// there are no distances.
std::optional<FitBasis> fitBasis(const Case& session, const RegistrationResult& result,
                                 const std::map<int, std::vector<double>>& residualPx);
std::optional<FitBasis> fitBasis(const Case& session, const RegistrationResult& result, const Centerline2d& target);

/// Returns the median over every point of the tree, px; 0 if there is none.
double medianOf(const std::map<int, std::vector<double>>& residualPx);

/// Evaluates a pose without changing it. Fails as evaluatePose does.
Result<PoseJudgement> judgementOf(const RegistrationInput& input, const RigidTransform& cameraFromPatient);

}   // namespace angiopose::core
