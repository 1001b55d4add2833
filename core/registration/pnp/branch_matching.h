#pragma once

#include "core/registration/matching/bin_grid.h"
#include "core/registration/pnp/branch_graph.h"
#include "core/registration/pose/centroid_pose.h"

#include <map>
#include <optional>
#include <set>
#include <utility>

namespace angiopose::core {

/// Tree point and the matching traced point.
struct BranchPair {
    std::size_t point = 0;   ///< index of the tree point
    Eigen::Vector2d pixel;
};

/// Assigns traced curves to tree segments by graph matching: relaxes the closeness of segment and curve together with
/// the consistency of the junctions in tree and image (Rosenfeld, Hummel, Zucker 1976; ALGORITHMS §3.9).
class BranchMatcher {
public:
    static constexpr int noCurve = -1;

    /// `problem` must outlive the matching.
    explicit BranchMatcher(const RegistrationProblem& problem);

    const BranchGraph& tree() const { return tree_; }

    /// Returns the curve matched to each edge of the tree's graph, or noCurve; `reachPx` is the 1-σ image misalignment.
    std::vector<int> match(const CentroidPose& pose, double reachPx) const;

    /// Returns the nearest points on the matched curves that are within three times `reachPx` and have a similar
    /// direction.
    std::vector<BranchPair> pairs(const CentroidPose& pose, double reachPx) const;

private:
    using Candidates = std::map<int, double>;   ///< probability of each curve; the remainder to 1 is that of no curve

    struct ProjectedSample {
        Eigen::Vector2d pixel;
        Eigen::Vector2d direction;   ///< unit vector
    };
    struct CurveRange {
        std::size_t from, to;   ///< range of the target points of one curve
    };
    std::optional<ProjectedSample> projectSample(std::size_t point, const CentroidPose& pose) const;
    Candidates closenessOf(const BranchEdge& edge, const CentroidPose& pose, double reachPx, const BinGrid& grid) const;
    static Candidates candidatesOf(const Candidates& closeness);
    double supportOf(int curve, const std::vector<int>& neighbors, const std::vector<Candidates>& candidates) const;
    void relaxCandidates(std::vector<Candidates>& candidates) const;
    bool areConnected(int a, int b) const { return a == b || connectedCurves_.contains({a, b}); }
    std::optional<Eigen::Vector2d> matchOnCurve(const ProjectedSample& sample, const CurveRange& curve,
                                                double reachPx) const;

    const RegistrationProblem& problem_;
    BranchGraph tree_;
    std::vector<std::vector<int>> neighbors_;   ///< for each edge, the edges that share a node with it
    std::set<std::pair<int, int>> connectedCurves_;   ///< pairs of connected curves
    std::map<int, CurveRange> curves_;
};

}   // namespace angiopose::core
