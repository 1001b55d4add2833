#include "core/registration/methods/methods.h"

#include "core/registration/methods/kernel_finish.h"
#include "core/registration/pnp/graph_score.h"
#include "core/registration/pnp/pair_fit.h"
#include "core/registration/pnp/traced_path.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <set>

namespace angiopose::core {
namespace {

constexpr std::size_t maxRootTrials = 20000;
constexpr std::size_t maxRoots = 24;
constexpr std::size_t pairsPerBranch = 12;
constexpr double branchHeadingMm = 12.0;
constexpr double pathHeadingPx = 20.0;
constexpr double minLikeCosine = 0.5;   // cosine of 60°
constexpr double undirectedPx = 3.0;   // minimum projected length of a branch for a meaningful direction
constexpr double graphRotationStd = 0.15;   // rad
constexpr double graphShiftStdMm = 30.0;
constexpr double graphPairStdMm = 1.0;
constexpr int graphFitSteps = 3;
constexpr std::size_t graphFinalists = 3;
constexpr double distinctFinalistsMm = 3.0;

/// Tree branch still to be matched, and the traced node at which it starts.
struct OpenBranch {
    EdgeEnd branch;
    int tracedNode = 0;
};

/// Sequence of matched branches and the resulting pose.
struct Matched {
    CentroidPose pose;
    double score = 0.0;
    std::vector<PointPixelPair> pairs;
    std::set<int> branches;   ///< tree edges already decided
    std::set<int> traced;   ///< traced edges already used
    std::deque<OpenBranch> open;
};

Vector6d graphPriorStd()
{
    Vector6d std;
    std << graphRotationStd, graphRotationStd, graphRotationStd, graphShiftStdMm, graphShiftStdMm, graphShiftStdMm;
    return std;
}

/// Best-first search over sequences of matched branches (ALGORITHMS §3.17).
class GraphSearch {
public:
    GraphSearch(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress);

    /// Expands states until none is left or the budget is spent.
    void run();
    void refine();
    MethodSolution solution() const { return search_.solution(StopReason::Converged); }

private:
    struct Root {
        double score;
        int node, tracedNode;
        CentroidPose pose;
    };
    int budget() const { return options_.graph.hypotheses + static_cast<int>(graphFinalists) * kernelFinishIterations; }
    const TreeSamples& tree() const { return problem_.tree; }
    std::size_t pointAt(const EdgeEnd& branch, std::size_t step) const;
    Eigen::Vector3d nodePlace(int node) const;   ///< mm, relative to the centroid
    Eigen::Vector2d tracedPlace(int node) const;
    std::optional<Eigen::Vector2d> pixelOf(const Eigen::Vector3d& fromCentroid, const CentroidPose& pose) const;
    std::vector<Eigen::Vector2d> projected(const EdgeEnd& branch, const CentroidPose& pose) const;
    std::vector<Root> roots();
    CentroidPose shiftedOnto(int node, int tracedNode) const;
    void open(Matched& state, int node, int tracedNode) const;
    std::vector<Matched> successors(const Matched& state);
    std::optional<Matched> extended(const Matched& rest, const OpenBranch& open, const EdgeEnd& way) const;
    bool haveSimilarCourse(const EdgeEnd& branch, const TracedPath& path, const CentroidPose& pose) const;

    const RegistrationProblem& problem_;
    const RegistrationOptions& options_;
    BranchGraph branches_;
    BranchGraph traced_;
    GraphScore score_;
    PoseTrials search_;
    InitialPosePrior prior_;
    std::vector<std::pair<double, CentroidPose>> tried_;
};

GraphSearch::GraphSearch(const RegistrationProblem& problem, const RegistrationOptions& options, ProgressLog& progress)
    : problem_(problem),
      options_(options),
      branches_(graphOf(problem.tree)),
      traced_(graphOf(problem.target)),
      score_(problem, options.graph.spreadWeight),
      search_(problem, budget(), progress),
      prior_(independentPrior(search_.start(), graphPriorStd(), problem.freedom))
{
}

std::size_t GraphSearch::pointAt(const EdgeEnd& branch, std::size_t step) const
{
    const BranchEdge& edge = branches_.edges[static_cast<std::size_t>(branch.edge)];
    return branch.isReversed ? edge.to - 1 - step : edge.from + step;
}

Eigen::Vector3d GraphSearch::nodePlace(int node) const
{
    return tree().points[pointAt(branches_.nodes[static_cast<std::size_t>(node)].front(), 0)] - tree().centroid;
}

Eigen::Vector2d GraphSearch::tracedPlace(int node) const
{
    const EdgeEnd& end = traced_.nodes[static_cast<std::size_t>(node)].front();
    const BranchEdge& edge = traced_.edges[static_cast<std::size_t>(end.edge)];
    return problem_.target.points[end.isReversed ? edge.to - 1 : edge.from];
}

std::optional<Eigen::Vector2d> GraphSearch::pixelOf(const Eigen::Vector3d& fromCentroid, const CentroidPose& pose) const
{
    return project(problem_.camera, pose.rotation * fromCentroid + pose.centroidInCamera);
}

/// Returns the projected points of a branch; empty if a point does not project.
std::vector<Eigen::Vector2d> GraphSearch::projected(const EdgeEnd& branch, const CentroidPose& pose) const
{
    const std::size_t count = branches_.edges[static_cast<std::size_t>(branch.edge)].size();
    std::vector<Eigen::Vector2d> pixels;
    for (std::size_t step = 0; step < count; ++step) {
        const auto pixel = pixelOf(tree().points[pointAt(branch, step)] - tree().centroid, pose);
        if (!pixel) {
            return {};
        }
        pixels.push_back(*pixel);
    }
    return pixels;
}

/// Returns the initial pose, shifted across the ray until the tree node projects onto the traced node.
CentroidPose GraphSearch::shiftedOnto(int node, int tracedNode) const
{
    CentroidPose pose = search_.start();
    const Eigen::Vector3d place = pose.rotation * nodePlace(node) + pose.centroidInCamera;
    const Eigen::Vector3d ray = rayThroughPixel(problem_.camera, tracedPlace(tracedNode));
    pose.centroidInCamera += place.z() / ray.z() * ray - place;
    return problem_.freedom.restoreLockedAxes(pose);
}

/// Returns the pairs of nodes of the same kind (bifurcation or end) that are close at the initial pose, limited to
/// those that fit the whole tree best.
std::vector<GraphSearch::Root> GraphSearch::roots()
{
    struct Near {
        double gapPx;
        int node, tracedNode;
    };
    std::vector<Near> near;
    for (int node = 0; node < static_cast<int>(branches_.nodes.size()); ++node) {
        const auto pixel = pixelOf(nodePlace(node), search_.start());
        const std::size_t ways = branches_.nodes[static_cast<std::size_t>(node)].size();
        for (int other = 0; pixel && other < static_cast<int>(traced_.nodes.size()); ++other) {
            const std::size_t otherWays = traced_.nodes[static_cast<std::size_t>(other)].size();
            const double gapPx = (tracedPlace(other) - *pixel).norm();
            if ((ways > 1) == (otherWays > 1) && gapPx <= options_.graph.reachPx) {
                near.push_back({gapPx, node, other});
            }
        }
    }
    std::ranges::stable_sort(near, {}, &Near::gapPx);
    near.resize(std::min(near.size(), maxRootTrials));
    std::vector<Root> found;
    for (const Near& pair : near) {
        const CentroidPose pose = shiftedOnto(pair.node, pair.tracedNode);
        found.push_back({score_.scoreAt(pose), pair.node, pair.tracedNode, pose});
    }
    std::ranges::stable_sort(found, std::ranges::greater{}, &Root::score);
    found.resize(std::min(found.size(), maxRoots));
    return found;
}

void GraphSearch::open(Matched& state, int node, int tracedNode) const
{
    for (const EdgeEnd& branch : branches_.nodes[static_cast<std::size_t>(node)]) {
        if (!state.branches.contains(branch.edge)) {
            state.open.push_back({branch, tracedNode});
        }
    }
}

bool GraphSearch::haveSimilarCourse(const EdgeEnd& branch, const TracedPath& path, const CentroidPose& pose) const
{
    const std::size_t count = branches_.edges[static_cast<std::size_t>(branch.edge)].size();
    const Eigen::Vector3d first = tree().points[pointAt(branch, 0)];
    std::size_t step = 0;
    while (step + 1 < count && (tree().points[pointAt(branch, step)] - first).norm() < branchHeadingMm) {
        ++step;
    }
    const auto from = pixelOf(first - tree().centroid, pose);
    const auto to = pixelOf(tree().points[pointAt(branch, step)] - tree().centroid, pose);
    if (!from || !to) {
        return false;
    }
    const Eigen::Vector2d heading = *to - *from;
    const Eigen::Vector2d other = pointAtLength(path.points, pathHeadingPx) - path.points.front();
    return heading.norm() < undirectedPx || heading.dot(other) > minLikeCosine * heading.norm() * other.norm();
}

/// Returns the match extended by one branch along this edge; nullopt if the courses of branch and edge differ.
std::optional<Matched> GraphSearch::extended(const Matched& rest, const OpenBranch& open, const EdgeEnd& way) const
{
    const std::vector<Eigen::Vector2d> seen = projected(open.branch, rest.pose);
    const double lengthPx = lengthOf(seen);
    if (!(lengthPx > 0.0)) {
        return {};
    }
    const TracedPath path = followPath(traced_, problem_.target, way, lengthPx);
    const bool isTaken = std::ranges::any_of(path.edges, [&](int edge) { return rest.traced.contains(edge); });
    if (isTaken || !haveSimilarCourse(open.branch, path, rest.pose)) {
        return {};
    }
    Matched next = rest;
    next.traced.insert(path.edges.begin(), path.edges.end());
    const double stretch = path.endNode == TracedPath::noNode ? 1.0 : path.lengthPx / lengthPx;
    const std::size_t stride = std::max<std::size_t>(1, seen.size() / pairsPerBranch);
    double along = 0.0;
    for (std::size_t step = 0; step < seen.size(); ++step) {
        along += step > 0 ? (seen[step] - seen[step - 1]).norm() : 0.0;
        if (step % stride == 0) {
            next.pairs.push_back({tree().points[pointAt(open.branch, step)] - tree().centroid,
                                  pointAtLength(path.points, stretch * along)});
        }
    }
    if (path.endNode != TracedPath::noNode) {
        this->open(next, branches_.targetNode(open.branch), path.endNode);
    }
    next.pose = fitPairs(next.pairs, problem_.camera, prior_, graphPairStdMm, graphFitSteps, rest.pose);
    next.score = score_.scoreAt(next.pose);
    return next;
}

/// Returns all possible decisions for the first open branch; the last one is that the image does not show the branch.
std::vector<Matched> GraphSearch::successors(const Matched& state)
{
    Matched rest = state;
    while (!rest.open.empty() && rest.branches.contains(rest.open.front().branch.edge)) {
        rest.open.pop_front();
    }
    if (rest.open.empty()) {
        return {};
    }
    const OpenBranch open = rest.open.front();
    rest.open.pop_front();
    rest.branches.insert(open.branch.edge);
    std::vector<Matched> next;
    for (const EdgeEnd& way : traced_.nodes[static_cast<std::size_t>(open.tracedNode)]) {
        if (auto more = rest.traced.contains(way.edge) ? std::nullopt : extended(rest, open, way)) {
            search_.recordTrial(more->pose, -more->score);
            next.push_back(std::move(*more));
        }
    }
    next.push_back(std::move(rest));
    return next;
}

void GraphSearch::run()
{
    search_.startStage("graph", GraphScore::scalePx, -score_.scoreAt(search_.start()));
    search_.advanceProgress();
    std::vector<Matched> states;
    std::set<std::pair<double, std::size_t>> queue;   // best first; ties in order of creation
    const auto add = [&](Matched state) {
        queue.emplace(-state.score, states.size());
        tried_.emplace_back(state.score, state.pose);
        states.push_back(std::move(state));
    };
    for (const Root& root : roots()) {
        Matched state;
        state.pose = root.pose;
        state.score = root.score;
        open(state, root.node, root.tracedNode);
        add(std::move(state));
    }
    int left = options_.graph.hypotheses;
    while (!queue.empty() && left > 0 && !search_.isStopped()) {
        const std::size_t best = queue.begin()->second;
        queue.erase(queue.begin());
        const Matched state = std::move(states[best]);
        for (Matched& next : successors(state)) {
            --left;
            add(std::move(next));
        }
    }
}

void GraphSearch::refine()
{
    tried_.emplace_back(score_.scoreAt(search_.start()), search_.start());
    std::ranges::stable_sort(tried_, std::ranges::greater{}, [](const auto& tried) { return tried.first; });
    std::vector<CentroidPose> finalists;
    for (const auto& [score, pose] : tried_) {
        const bool isNew = std::ranges::none_of(finalists, [this, &candidate = pose](const CentroidPose& known) {
            return stepLengthMm(stepBetween(known, candidate), tree().spreadMm) < distinctFinalistsMm;
        });
        if (isNew && finalists.size() < graphFinalists) {
            finalists.push_back(pose);
        }
    }
    refineByKernel(problem_, finalists, options_.finalScalePx, search_);
}

}   // namespace

MethodSolution solveGraphMatching(const RegistrationProblem& problem, const RegistrationOptions& options,
                                  ProgressLog& progress)
{
    Stopwatch stopwatch;
    GraphSearch search(problem, options, progress);
    const double targetMs = stopwatch.takeLapMs();
    search.run();
    const double searchMs = stopwatch.takeLapMs();
    search.refine();
    MethodSolution solution = search.solution();
    solution.time.targetMs = targetMs;
    solution.time.searchMs = searchMs;
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core
