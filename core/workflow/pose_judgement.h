#pragma once

#include "core/case/case.h"

#include <map>
#include <optional>
#include <vector>

namespace angiopose::core {

/// How a pose agrees with the image, as a whole and at every point of the tree.
struct PoseJudgement {
    RegistrationResult result;   ///< of evaluatePose
    std::map<int, std::vector<double>> residualPx;   ///< per branch id, one value per tree point, see branchDistances
};

/// What the distances of a result are about, and what they leave out.
struct FitBasis {
    double judgedShare = 1.0;   ///< of the tree, 0…1: the rest is judged unopacified
    double wholeMedianMm = 0.0,
           wholeP95Mm = 0.0;   ///< over every point of the tree, whatever is excluded or unopacified
    std::vector<std::pair<int, double>> excludedMm, auxiliaryMm;   ///< branches and their medians
};

/// The basis of `result` of the shown view, whose distances `residualPx` are (see branchDistances); none of them: none.
std::optional<FitBasis> fitBasis(const Case& session, const RegistrationResult& result,
                                 const std::map<int, std::vector<double>>& residualPx);
std::optional<FitBasis> fitBasis(const Case& session, const RegistrationResult& result, const Centerline2d& target);

/// Over every point of the tree, px; 0 where there is none.
double medianOf(const std::map<int, std::vector<double>>& residualPx);

/// Judges a pose without moving it. Fails as evaluatePose.
Result<PoseJudgement> judgementOf(const RegistrationInput& input, const RigidTransform& cameraFromPatient);

}   // namespace angiopose::core
