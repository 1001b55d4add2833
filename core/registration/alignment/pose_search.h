#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/problem/registration_result.h"

#include <functional>

namespace angiopose::core {

/// Receives the completed fraction, 0…1; if it returns Stop, the search ends with the results so far.
using SearchObserver = std::function<ObserverDecision(double)>;

/// Coarse searches that return poses for refinement, best first (ALGORITHMS §6.8). The options limit their ranges.
class PoseSearch {
public:
    PoseSearch(const RegistrationProblem& problem, const TargetLines& target, const RegistrationOptions& options);

    /// Searches the error range of an initial pose from the DICOM header, with fine rotation steps and short shifts.
    std::vector<CentroidPose> searchNearby(const CentroidPose& start, const SearchObserver& observe) const;

    /// Searches all shifts and rotations of up to 30° in coarse steps.
    std::vector<CentroidPose> searchWide(const CentroidPose& start, const SearchObserver& observe) const;

    /// Searches a medium range; scores only how well the tree explains the traced vessels, regardless of how much of
    /// the tree is opacified.
    std::vector<CentroidPose> searchByTerritories(const CentroidPose& start, const SearchObserver& observe) const;

    /// Searches the full range by matching bifurcations.
    std::vector<CentroidPose> searchByJunctions(const CentroidPose& start, const SearchObserver& observe) const;

    /// Searches the error range of the initial pose with the auxiliary branches {p'} only.
    std::vector<CentroidPose> searchWithAuxiliary(const CentroidPose& start, const SearchObserver& observe) const;

    /// Returns the initial pose shifted to project the tree's centroid onto the traced vessels' center (ALGORITHMS
    /// §5.4).
    CentroidPose recenterPose(const CentroidPose& start) const;

private:
    const RegistrationProblem& problem_;
    const TargetLines& target_;
    const RegistrationOptions& options_;
};

}   // namespace angiopose::core
