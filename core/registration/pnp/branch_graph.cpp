#include "core/registration/pnp/branch_graph.h"

#include "core/registration/alignment/branch_segments.h"
#include "core/registration/matching/bin_grid.h"

#include <algorithm>
#include <numeric>

namespace angiopose::core {
namespace {

constexpr double curvesTouchPx = 5.0;

/// Union-find that numbers groups of joined members in the order of their first members.
class Grouping {
public:
    explicit Grouping(std::size_t count) : leader_(count) { std::iota(leader_.begin(), leader_.end(), std::size_t{0}); }

    void join(std::size_t a, std::size_t b)
    {
        a = leaderOf(a);
        b = leaderOf(b);
        leader_[std::max(a, b)] = std::min(a, b);
    }

    std::vector<int> numbers()
    {
        std::vector<int> numbers(leader_.size());
        int next = 0;
        for (std::size_t i = 0; i < leader_.size(); ++i) {
            const std::size_t leader = leaderOf(i);   // not greater than i
            numbers[i] = leader == i ? next++ : numbers[leader];
        }
        return numbers;
    }

private:
    std::size_t leaderOf(std::size_t i)
    {
        while (leader_[i] != i) {
            leader_[i] = leader_[leader_[i]];
            i = leader_[i];
        }
        return i;
    }

    std::vector<std::size_t> leader_;
};

/// Returns two ends per edge: its first point, and the point after its last one if the curve continues.
std::vector<Eigen::Vector3d> endsOf(const std::vector<BranchSegment>& pieces,
                                    const std::vector<Eigen::Vector3d>& points, const std::vector<int>& curveIndex)
{
    std::vector<Eigen::Vector3d> ends;
    for (const BranchSegment& piece : pieces) {
        const bool shouldContinue = piece.to < points.size() && curveIndex[piece.to] == piece.branchIndex;
        ends.push_back(points[piece.from]);
        ends.push_back(points[shouldContinue ? piece.to : piece.to - 1]);
    }
    return ends;
}

BranchGraph graphOf(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& curveIndex, double maxGap)
{
    const std::vector<BranchSegment> pieces = splitAtBifurcations(points, curveIndex, maxGap).pieces;
    const std::vector<Eigen::Vector3d> ends = endsOf(pieces, points, curveIndex);
    std::vector<Eigen::Vector2d> flat(ends.size());
    std::ranges::transform(ends, flat.begin(), [](const Eigen::Vector3d& end) { return end.head<2>(); });
    BinGrid near;
    near.fill(flat, maxGap);
    Grouping groups(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
        near.visitNear(flat[i], [&](std::size_t j) {
            if (j < i && (ends[j] - ends[i]).norm() <= maxGap) {
                groups.join(i, j);
            }
        });
    }
    const std::vector<int> nodes = groups.numbers();
    BranchGraph graph;
    graph.nodes.resize(nodes.empty() ? 0 : static_cast<std::size_t>(*std::ranges::max_element(nodes)) + 1);
    for (std::size_t e = 0; e < pieces.size(); ++e) {
        const auto edge = static_cast<int>(e);
        graph.edges.push_back({pieces[e].branchIndex, pieces[e].from, pieces[e].to, {nodes[2 * e], nodes[2 * e + 1]}});
        graph.nodes[static_cast<std::size_t>(nodes[2 * e])].push_back({edge, false});
        graph.nodes[static_cast<std::size_t>(nodes[2 * e + 1])].push_back({edge, true});
    }
    return graph;
}

}   // namespace

BranchGraph graphOf(const TreeSamples& tree)
{
    return graphOf(tree.points, tree.branchIndex, maxBranchGapMm);
}

BranchGraph graphOf(const TargetSamples& target)
{
    std::vector<Eigen::Vector3d> points;
    points.reserve(target.size());
    for (const Eigen::Vector2d& point : target.points) {
        points.emplace_back(point.x(), point.y(), 0.0);
    }
    return graphOf(points, target.curveIndex, curvesTouchPx);
}

}   // namespace angiopose::core
