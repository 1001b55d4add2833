#pragma once

#include "core/registration/wire/follow_wire.h"
#include "core/registration/wire/wire_fit.h"
#include "core/vessel/vessel_tree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace angiopose::core {

inline constexpr double wireKnotSpacingMm = 2.0;   ///< spacing of the tree's knots, larger in large trees

/// Joint result of all paths fitted to a wire: merges indistinguishable ones, computes their probabilities and the pose
/// uncertainty over all of them (ALGORITHMS §6.22). All inputs must outlive it.
class WireReport {
public:
    /// `tree` is the one whose knots `wire` holds; `mmPerPx` is at the tree's depth.
    WireReport(const RegistrationProblem& problem, const VesselTree& tree, const WireProblem& wire,
               const WireModel& model, double mmPerPx);

    /// `fits` are sorted most likely first; `wantedWay` is the rank of the path to use, 1 the most likely.
    WireFinding of(const std::vector<WireFit>& fits, std::size_t wantedWay) const;

private:
    /// Representative of the paths that the image does not distinguish.
    struct ReportedPath {
        WirePath path;   ///< most likely path
        const WireFit* fit = nullptr;   ///< fit of that path
        std::vector<std::size_t> course;   ///< knots along the wire, sorted
        std::vector<double> logEvidences;   ///< evidence of each of these paths
    };

    std::vector<int> branchesOf(const WireFit& fit) const;
    WirePath pathOf(const WireFit& fit) const;
    std::vector<ReportedPath> reportedPaths(const std::vector<WireFit>& fits) const;
    std::vector<std::size_t> courseOf(const WireFit& fit) const;
    std::vector<std::uint8_t> followedBy(const WireFit& fit) const;
    void shareOut(std::vector<ReportedPath>& reported) const;
    Matrix6d spreadOf(const std::vector<ReportedPath>& reported) const;

    const RegistrationProblem& problem_;
    const VesselTree& tree_;
    const WireProblem& wire_;
    const WireModel& model_;
    double mmPerPx_;
};

}   // namespace angiopose::core
