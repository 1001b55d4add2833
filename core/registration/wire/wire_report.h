#pragma once

#include "core/registration/wire/follow_wire.h"
#include "core/registration/wire/wire_fit.h"
#include "core/vessel/vessel_tree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace angiopose::core {

inline constexpr double wireKnotSpacingMm = 2.0;   ///< of the tree's knots, farther in large trees

/// What the ways that were fitted to a wire say together: which of them are told as one, how likely each is, and how
/// far the pose may be off for all of them (ALGORITHMS §6.22). All that it is made from must outlive it.
class WireReport {
public:
    /// `tree`: the one whose knots `wire` holds; `mmPerPx`: at the tree's depth.
    WireReport(const RegistrationProblem& problem, const VesselTree& tree, const WireProblem& wire,
               const WireModel& model, double mmPerPx);

    /// `fits`: most likely first; `wantedWay`: the one to be taken, 1 the most likely.
    WireFinding of(const std::vector<WireFit>& fits, std::size_t wantedWay) const;

private:
    /// What stands for the ways that the image does not tell apart.
    struct ReportedPath {
        WirePath path;   ///< of the most likely
        const WireFit* fit = nullptr;   ///< of the same
        std::vector<std::size_t> course;   ///< knots beside the wire, sorted
        std::vector<double> logEvidences;   ///< of them all
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
