#pragma once

#include "core/registration/matching/bin_grid.h"
#include "core/registration/pnp/branch_graph.h"
#include "core/registration/pose/centroid_pose.h"

#include <map>
#include <optional>
#include <set>
#include <utility>

namespace angiopose::core {

/// A tree point and the traced point that it belongs to.
struct BranchPair {
    std::size_t point = 0;   ///< number of the tree point
    Eigen::Vector2d pixel;
};

/// Which traced curve shows which stretch of the tree, by graph matching: how near a stretch runs to a curve, and
/// whether what meets in the tree meets in the image, relaxed together (Rosenfeld, Hummel, Zucker 1976;
/// ALGORITHMS §3.9).
class BranchMatching {
public:
    static constexpr int noCurve = -1;

    /// `problem` outlives it.
    explicit BranchMatching(const RegistrationProblem& problem);

    const BranchGraph& tree() const { return tree_; }

    /// The curve of each edge of the tree's graph, or noCurve; `reachPx`: 1-σ of how far the image may be off.
    std::vector<int> match(const CentroidPose& pose, double reachPx) const;

    /// Nearest points on the matched curves, within three times the reach and in a like direction.
    std::vector<BranchPair> pairs(const CentroidPose& pose, double reachPx) const;

private:
    using Candidates = std::map<int, double>;   ///< how likely each curve is; the rest to 1: none

    struct Seen {
        Eigen::Vector2d pixel;
        Eigen::Vector2d direction;   ///< unit
    };
    struct Stretch {
        std::size_t from, to;   ///< target points of one curve
    };
    std::optional<Seen> look(std::size_t point, const CentroidPose& pose) const;
    Candidates closenessOf(const BranchEdge& edge, const CentroidPose& pose, double reachPx, const BinGrid& near) const;
    static Candidates candidatesOf(const Candidates& closeness);
    double supportOf(int curve, const std::vector<int>& neighbors, const std::vector<Candidates>& candidates) const;
    void relax(std::vector<Candidates>& candidates) const;
    bool meet(int a, int b) const { return a == b || meetings_.contains({a, b}); }
    std::optional<Eigen::Vector2d> partnerOf(const Seen& seen, const Stretch& curve, double reachPx) const;

    const RegistrationProblem& problem_;
    BranchGraph tree_;
    std::vector<std::vector<int>> neighbors_;   ///< edges that share a node with each edge
    std::set<std::pair<int, int>> meetings_;   ///< of curves
    std::map<int, Stretch> curves_;
};

}   // namespace angiopose::core
