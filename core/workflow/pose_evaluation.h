#pragma once

#include "core/case/case.h"

#include <map>
#include <optional>
#include <vector>

namespace angiopose::core {

/// Agreement of a pose with the image, overall and at every point of the tree.
struct PoseEvaluation {
    RegistrationResult result;   ///< result of evaluatePose
    std::map<int, std::vector<double>> residualPx;   ///< per branch id, one value per tree point, see branchDistances
};

/// The part of the tree on which the distances of a result are based, and the distances of the other branches.
struct FitBasis {
    double assessedFraction =
        1.0;   ///< fraction of the tree that was compared, 0…1; the rest is considered unopacified
    double wholeMedianMm = 0.0,
           wholeP95Mm = 0.0;   ///< over all points of the tree, including excluded and unopacified branches
    std::vector<std::pair<int, double>> excludedMm, auxiliaryMm;   ///< pairs of branch id and median distance
};

/// Returns the basis of `result` for the shown view from the distances `residualPx` (see branchDistances); nullopt if
/// there are no distances.
std::optional<FitBasis> fitBasis(const Case& session, const RegistrationResult& result,
                                 const std::map<int, std::vector<double>>& residualPx);
std::optional<FitBasis> fitBasis(const Case& session, const RegistrationResult& result, const Centerline2d& target);

/// Returns the median distance over all points of the tree, px; 0 if there is no point.
double medianOf(const std::map<int, std::vector<double>>& residualPx);

/// Evaluates a pose without changing it. Fails under the same conditions as evaluatePose.
Result<PoseEvaluation> evaluateWithResiduals(const RegistrationInput& input, const RigidTransform& cameraFromPatient);

}   // namespace angiopose::core
