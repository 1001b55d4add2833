#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/coarse_candidate.h"
#include "core/registration/problem/registration_result.h"

#include <cstdint>
#include <functional>
#include <span>

namespace angiopose::core {

/// Search range around the initial pose and angular step of the search.
struct SearchRange {
    double radiusMm = 60.0;
    double tiltDeg = 10.0;   ///< maximum length of the tilt's rotation vector
    double rollDeg = 10.0;
    double stepDeg = 4.0;
    PoseFreedom freedom{};   ///< locked degrees of freedom are not searched
};

/// Searches all tilts, rolls and 2-D shifts exhaustively (ALGORITHMS §6.8) by summing a closeness image of the target
/// over a few tree points. The image is stored with all shifts of one point contiguous in memory.
class CoarseSearch {
public:
    /// `closenessPx` is the distance at which a tree point still scores 0.6; coarser rotation steps need a larger value
    /// (ALGORITHMS §6.8: 11).
    CoarseSearch(const ProjectionCamera& camera, const TargetLines& target, double closenessPx = 11.0);

    /// Returns the best candidate of each basin, best first. `proceed` receives the completed fraction after each tilt;
    /// if it returns Stop, the search returns the candidates collected so far.
    std::vector<CoarseCandidate> find(std::span<const AlignmentPoint> points, const CentroidPose& start,
                                      const SearchRange& range,
                                      const std::function<ObserverDecision(double)>& observe) const;

private:
    struct Shifts;
    void addPoint(double u, double v, Shifts& shifts) const;
    void keepBest(const CentroidPose& pose, std::size_t pointCount, const Shifts& shifts,
                  std::vector<CoarseCandidate>& candidates) const;
    void scoreOrientation(std::span<const AlignmentPoint> points, const CentroidPose& pose, Shifts& shifts) const;

    ProjectionCamera camera_;
    int margin_ = 0;   ///< blocks added around the image
    int blockColumns_ = 0;
    int blockRows_ = 0;
    /// Closeness 0…255 at pixel (16 (bc − margin) + 4 pc, …), stored as one small row-major image of blocks per phase.
    std::vector<std::uint8_t> closeness_;
};

}   // namespace angiopose::core
