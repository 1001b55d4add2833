#pragma once

#include "core/registration/wire/find_wire_path.h"
#include "core/registration/wire/wire_fit.h"
#include "core/vessel/vessel_tree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace angiopose::core {

inline constexpr double wireKnotSpacingMm = 2.0;   ///< minimum knot spacing; large trees get a wider one

/// Combines all paths fitted to a wire: merges indistinguishable ones and computes their probabilities and the pose
/// uncertainty over all paths (ALGORITHMS §6.22). All inputs must outlive this object.
class WireReport {
public:
    /// `tree` must be the tree with the knots of `wire`; `mmPerPx` applies at the depth of the tree.
    WireReport(const RegistrationProblem& problem, const VesselTree& tree, const WireProblem& wire,
               const WireModel& model, double mmPerPx);

    /// `fits` are sorted most likely first; `pathRank` is the rank of the path to use, 1 the most likely.
    WireResult makeResult(const std::vector<WireFit>& fits, std::size_t pathRank) const;

private:
    /// Group of paths that the image cannot distinguish, represented by the most likely one.
    struct ReportedPath {
        WirePath path;   ///< most likely path
        const WireFit* fit = nullptr;   ///< fit of the most likely path
        std::vector<std::size_t> course;   ///< knots along the wire, sorted
        std::vector<double> logEvidences;   ///< log evidence of each path in the group
    };

    std::vector<int> branchesOf(const WireFit& fit) const;
    WirePath pathOf(const WireFit& fit) const;
    std::vector<ReportedPath> reportedPaths(const std::vector<WireFit>& fits) const;
    std::vector<std::size_t> courseOf(const WireFit& fit) const;
    std::vector<std::uint8_t> pointsOnPath(const WireFit& fit) const;
    void assignProbabilities(std::vector<ReportedPath>& reported) const;
    Matrix6d totalCovariance(const std::vector<ReportedPath>& reported) const;

    const RegistrationProblem& problem_;
    const VesselTree& tree_;
    const WireProblem& wire_;
    const WireModel& model_;
    double mmPerPx_;
};

}   // namespace angiopose::core
