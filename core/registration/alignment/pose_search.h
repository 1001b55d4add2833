#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/problem/registration_result.h"

#include <functional>

namespace angiopose::core {

/// Told the share done, 0…1; Stop ends a search with what it has.
using SearchObserver = std::function<Verdict(double)>;

/// Coarse searches for poses worth refining (ALGORITHMS §6.8), best first. Each covers what the options allow.
class PoseSearch {
public:
    PoseSearch(const RegistrationProblem& problem, const TargetLines& target, const RegistrationOptions& options);

    /// As far as a start pose by the DICOM header is off: fine turns, short shifts.
    std::vector<CentroidPose> nearby(const CentroidPose& start, const SearchObserver& observe) const;

    /// All of the shifts and turns of up to 30°, in coarse steps.
    std::vector<CentroidPose> wide(const CentroidPose& start, const SearchObserver& observe) const;

    /// By the vessels of the image alone, whatever of the tree they show; a middling reach in middling steps.
    std::vector<CentroidPose> ofTerritories(const CentroidPose& start, const SearchObserver& observe) const;

    /// All of the reach, by bifurcations.
    std::vector<CentroidPose> byJunctions(const CentroidPose& start, const SearchObserver& observe) const;

    /// The chosen {p'} alone, over the short reach.
    std::vector<CentroidPose> ofAuxiliary(const CentroidPose& start, const SearchObserver& observe) const;

    /// The start pose shifted so that the tree's centroid meets the middle of the traced vessels (ALGORITHMS §5.4).
    CentroidPose recentered(const CentroidPose& start) const;

private:
    const RegistrationProblem& problem_;
    const TargetLines& target_;
    const RegistrationOptions& options_;
};

}   // namespace angiopose::core