#include "core/simulation/fill_vessels.h"

#include "core/simulation/smooth_path.h"
#include "core/vessel/polyline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace core {
namespace {

constexpr double thinRadiusMm = 1.2;   ///< branches below are missing twice as often
constexpr double mixingMm = 12.0;   ///< way over which a child takes on its own opacity
constexpr double tipMm = 14.0;   ///< a vessel fades out over its last millimetres
constexpr double jetMm = 12.0;   ///< way over which the injected jet fills the inlet's lumen
constexpr double catheterRadiusMm = 0.8;
constexpr double catheterLengthMm = 320.0;

double smoothStep(double t)
{
    const double x = std::clamp(t, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

/// A branch without filled children, drawn at random, thin ones twice as often; the trunk never.
std::size_t drawEndBranch(const GrownTree& grown, const std::vector<bool>& filled, CounterRandom& random)
{
    std::vector<std::size_t> tickets;
    for (std::size_t b = 1; b < filled.size(); ++b) {
        bool hasFilledChild = false;
        for (std::size_t child = b + 1; child < filled.size(); ++child) {
            hasFilledChild =
                hasFilledChild || (filled[child] && grown.takeoffs[child].parentIndex == static_cast<int>(b));
        }
        if (filled[b] && !hasFilledChild) {
            const bool isThin = grown.tree.branches[b].radiusMm.front() < thinRadiusMm;
            tickets.insert(tickets.end(), isThin ? 2 : 1, b);
        }
    }
    return tickets.empty() ? 0 : tickets[static_cast<std::size_t>(random.index(static_cast<int>(tickets.size())))];
}

/// One flag per branch. Vessels close from their ends, so that no filled branch hangs on an empty one.
std::vector<bool> drawFilled(const GrownTree& grown, double missingShare, CounterRandom& random)
{
    std::vector<bool> filled(grown.tree.branches.size(), true);
    const auto missing = static_cast<int>(std::lround(missingShare * static_cast<double>(filled.size())));
    for (int i = 0; i < missing; ++i) {
        const std::size_t branch = drawEndBranch(grown, filled, random);
        if (branch != 0) {
            filled[branch] = false;
        }
    }
    return filled;
}

/// Share of a child's lumen at `point` that lies outside its parent: contrast there must not count twice.
double shareOutside(const VesselBranch& parent, const Eigen::Vector3d& point)
{
    double nearest = std::numeric_limits<double>::max();
    double radius = 1.0;
    for (std::size_t i = 0; i < parent.pointsInPatient.size(); ++i) {
        const double distance = (parent.pointsInPatient[i] - point).squaredNorm();
        if (distance < nearest) {
            nearest = distance;
            radius = parent.radiusMm[i];
        }
    }
    return smoothStep((std::sqrt(nearest) / radius - 0.3) / 0.9);
}

ContrastPath pathAlong(const VesselBranch& branch, double opacity, const ContrastPoint& inlet)
{
    ContrastPath path;
    double alongMm = 0.0;
    for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
        if (i > 0) {
            alongMm += (branch.pointsInPatient[i] - branch.pointsInPatient[i - 1]).norm();
        }
        const double mixed = inlet.opacity + (opacity - inlet.opacity) * smoothStep(alongMm / mixingMm);
        path.push_back({branch.pointsInPatient[i], branch.radiusMm[i], mixed, inlet.pathMm + alongMm});
    }
    return path;
}

/// What is drawn of a path: vessels dwindle at their tips, inside the parent nothing counts twice, and without a
/// parent the contrast enters gradually.
ContrastPath drawn(ContrastPath path, const VesselBranch* parent)
{
    const double endMm = path.back().pathMm;
    for (ContrastPoint& point : path) {
        point.opacity *= 0.15 + 0.85 * smoothStep((endMm - point.pathMm) / tipMm);
        point.opacity *= parent != nullptr ? shareOutside(*parent, point.pointInPatient)
                                           : 0.1 + 0.9 * smoothStep(point.pathMm / jetMm);
    }
    return path;
}

/// A vessel that the tree does not have, leaving `parent` somewhere in its middle.
VesselBranch growExtra(const VesselBranch& parent, std::size_t takeoff, CounterRandom& random)
{
    const Eigen::Vector3d tangent = polylineTangents<3>(parent.pointsInPatient, 3)[takeoff];
    const Eigen::Vector3d side =
        Eigen::AngleAxisd(random.uniform(0.0, 2.0 * std::numbers::pi), tangent) * tangent.unitOrthogonal();
    PathPlan plan;
    plan.start = parent.pointsInPatient[takeoff];
    plan.startDirection = (tangent + random.uniform(0.6, 1.2) * side).normalized();
    plan.endDirection = (0.4 * tangent + side).normalized();
    plan.end = plan.start + random.uniform(25.0, 70.0) * (0.5 * tangent + side).normalized();
    VesselBranch extra;
    extra.pointsInPatient = smoothPath(plan, random);
    const double inletRadiusMm = 0.6 * parent.radiusMm[takeoff];
    for (std::size_t i = 0; i < extra.pointsInPatient.size(); ++i) {
        const double along = static_cast<double>(i) / static_cast<double>(extra.pointsInPatient.size() - 1);
        extra.radiusMm.push_back(inletRadiusMm * (1.0 - 0.4 * along));
    }
    return extra;
}

/// The catheter comes from outside the field and ends in the inlet; contrast runs through it first.
ContrastPath layCatheter(const VesselBranch& trunk, CounterRandom& random)
{
    const Eigen::Vector3d inlet = trunk.pointsInPatient.front();
    const Eigen::Vector3d forward = polylineTangents<3>(trunk.pointsInPatient, 4).front();
    const Eigen::Vector3d side =
        Eigen::AngleAxisd(random.uniform(0.0, 2.0 * std::numbers::pi), forward) * forward.unitOrthogonal();
    PathPlan plan;
    plan.start = inlet - catheterLengthMm * (forward + random.uniform(0.2, 0.7) * side).normalized();
    plan.end = inlet;
    plan.startDirection = forward;
    plan.endDirection = forward;
    plan.tortuosity = 0.6;
    const std::vector<Eigen::Vector3d> points = smoothPath(plan, random);
    const double opacity = random.uniform(0.5, 1.0);
    const double lengthMm = polylineLength<3>(points);
    ContrastPath catheter;
    double alongMm = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        alongMm += i > 0 ? (points[i] - points[i - 1]).norm() : 0.0;
        catheter.push_back({points[i], catheterRadiusMm, opacity, alongMm - lengthMm});
    }
    return catheter;
}

void addExtras(FilledVessels& vessels, double share, CounterRandom& random)
{
    const std::vector<VesselBranch> parents = vessels.visible.branches;
    int nextId = 0;
    for (const VesselBranch& branch : parents) {
        nextId = std::max(nextId, branch.id);
    }
    for (const int id : vessels.missingBranchIds) {
        nextId = std::max(nextId, id);
    }
    for (std::size_t b = 0; b < parents.size(); ++b) {
        const auto count = static_cast<double>(parents[b].pointsInPatient.size());
        const auto takeoff = static_cast<std::size_t>(random.uniform(0.3, 0.8) * count);
        if (random.uniform() >= share) {
            continue;
        }
        VesselBranch extra = growExtra(parents[b], takeoff, random);
        extra.id = ++nextId;
        extra.name = "extra";
        const double opacity = random.uniform(0.3, 1.0);
        vessels.paths.push_back(drawn(pathAlong(extra, opacity, vessels.paths[b][takeoff]), &parents[b]));
        vessels.visible.branches.push_back(std::move(extra));
    }
}

}   // namespace

FilledVessels fillVessels(const GrownTree& grown, const DsaOptions& options, CounterRandom& random)
{
    const std::vector<VesselBranch>& branches = grown.tree.branches;
    const std::vector<bool> filled = drawFilled(grown, options.missingBranchShare, random);
    FilledVessels vessels;
    std::vector<ContrastPath> pathOf(branches.size());   // undiminished at the takeoff, for the children's inlets
    for (std::size_t b = 0; b < branches.size(); ++b) {
        const double opacity = random.uniform(b == 0 ? 0.85 : 0.3, 1.0);
        if (!filled[b]) {
            vessels.missingBranchIds.push_back(branches[b].id);
            continue;
        }
        const Takeoff& takeoff = grown.takeoffs[b];
        if (takeoff.parentIndex < 0) {
            pathOf[b] = pathAlong(branches[b], opacity, {{}, 0.0, opacity, 0.0});
            vessels.paths.push_back(drawn(pathOf[b], nullptr));
        } else {
            const auto parent = static_cast<std::size_t>(takeoff.parentIndex);
            pathOf[b] = pathAlong(branches[b], opacity, pathOf[parent][takeoff.parentPoint]);
            vessels.paths.push_back(drawn(pathOf[b], &branches[parent]));
        }
        vessels.visible.branches.push_back(branches[b]);
        vessels.longestPathMm = std::max(vessels.longestPathMm, pathOf[b].back().pathMm);
    }
    addExtras(vessels, options.extraBranchShare, random);
    if (random.uniform() < options.catheterProbability) {
        vessels.paths.push_back(layCatheter(branches.front(), random));
    }
    return vessels;
}

}   // namespace core
