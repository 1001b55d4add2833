#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/coarse_candidate.h"
#include "core/registration/problem/registration_result.h"

#include <cstdint>
#include <functional>
#include <span>

namespace angiopose::core {

/// Search range around the initial pose and angular step of the search.
struct SearchReach {
    double radiusMm = 60.0;
    double tiltDeg = 10.0;   ///< of the tilt's axis-angle length
    double rollDeg = 10.0;
    double stepDeg = 4.0;
    PoseFreedom freedom{};   ///< locked degrees of freedom are not searched
};

/// Exhaustive search over tilts, rolls and 2-D shifts (ALGORITHMS §6.8): sums a closeness image of the target over a
/// few tree points. The image is rearranged to store all shifts of one point contiguously.
class CoarseSearch {
public:
    /// `closenessPx` is the distance at which a tree point still counts 0.6; use a wider one for coarser rotation steps
    /// (ALGORITHMS §6.8: 11).
    CoarseSearch(const ProjectionCamera& camera, const TargetLines& target, double closenessPx = 11.0);

    /// Returns the best candidates, best first, each in its own basin. `proceed` receives the completed share after
    /// each tilt; Stop ends the search with the candidates found so far.
    std::vector<CoarseCandidate> find(std::span<const AlignmentPoint> points, const CentroidPose& start,
                                      const SearchReach& reach, const std::function<Verdict(double)>& proceed) const;

private:
    struct Shifts;
    void addPoint(double u, double v, Shifts& shifts) const;
    void keepBest(const CentroidPose& pose, std::size_t pointCount, const Shifts& shifts,
                  std::vector<CoarseCandidate>& found) const;
    void scoreOrientation(std::span<const AlignmentPoint> points, const CentroidPose& pose, Shifts& shifts) const;

    ProjectionCamera camera_;
    int margin_ = 0;   ///< blocks added around the image
    int blockColumns_ = 0;
    int blockRows_ = 0;
    /// Closeness 0…255 at pixel (16 (bc − margin) + 4 pc, …), stored phase by phase as small row-major images of
    /// blocks.
    std::vector<std::uint8_t> closeness_;
};

}   // namespace angiopose::core