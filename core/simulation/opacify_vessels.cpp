#include "core/simulation/opacify_vessels.h"

#include "core/simulation/grow_tree.h"
#include "core/simulation/smooth_path.h"
#include "core/simulation/smooth_step.h"
#include "core/vessel/polyline.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace angiopose::core {
namespace {

constexpr double catheterRadiusMm = 0.8;
constexpr double catheterLengthMm = 320.0;

Eigen::Vector3d randomNormal(const Eigen::Vector3d& direction, CounterRandom& random)
{
    const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
    return Eigen::AngleAxisd(turn, direction) * direction.unitOrthogonal();
}

/// Grows a thinner side branch that leaves `parent` at point `takeoff`; the caller sets id and name.
VesselBranch growSideBranch(const VesselBranch& parent, std::size_t takeoff, CounterRandom& random)
{
    const Eigen::Vector3d tangent = polylineTangents<3>(parent.pointsInPatient, 3)[takeoff];
    const Eigen::Vector3d side = randomNormal(tangent, random);
    PathPlan plan;
    plan.start = parent.pointsInPatient[takeoff];
    plan.startDirection = (tangent + random.uniform(0.6, 1.2) * side).normalized();
    plan.endDirection = (0.4 * tangent + side).normalized();
    plan.end = plan.start + random.uniform(25.0, 70.0) * (0.5 * tangent + side).normalized();
    VesselBranch branch;
    branch.pointsInPatient = smoothPath(plan, random);
    const double inletRadiusMm = 0.6 * parent.radiusMm[takeoff];
    for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
        const double along = static_cast<double>(i) / static_cast<double>(branch.pointsInPatient.size() - 1);
        branch.radiusMm.push_back(inletRadiusMm * (1.0 - 0.4 * along));
    }
    return branch;
}

/// Returns a catheter that enters from outside the field of view and ends where the trunk begins.
VesselBranch makeCatheter(const VesselBranch& trunk, CounterRandom& random)
{
    const Eigen::Vector3d forward = polylineTangents<3>(trunk.pointsInPatient, 4).front();
    const Eigen::Vector3d side = randomNormal(forward, random);
    PathPlan plan;
    plan.end = trunk.pointsInPatient.front();
    plan.start = plan.end - catheterLengthMm * (forward + random.uniform(0.2, 0.7) * side).normalized();
    plan.startDirection = forward;
    plan.endDirection = forward;
    plan.tortuosity = 0.6;
    VesselBranch catheter;
    catheter.pointsInPatient = smoothPath(plan, random);
    catheter.radiusMm.assign(catheter.pointsInPatient.size(), catheterRadiusMm);
    return catheter;
}

constexpr double thinRadiusMm = 1.2;   ///< radius below which branches are missing twice as often

bool hasOpacifiedChild(const GrownTree& grown, const std::vector<bool>& opacified, std::size_t branch)
{
    for (std::size_t child = branch + 1; child < opacified.size(); ++child) {
        if (opacified[child] && grown.takeoffs[child].parentIndex == static_cast<int>(branch)) {
            return true;
        }
    }
    return false;
}

/// Draws an opacified branch without opacified children; returns 0, the trunk, if there is none.
std::size_t drawEndBranch(const GrownTree& grown, const std::vector<bool>& opacified, CounterRandom& random)
{
    std::vector<std::size_t> weightedIndices;
    for (std::size_t b = 1; b < opacified.size(); ++b) {
        if (opacified[b] && !hasOpacifiedChild(grown, opacified, b)) {
            const bool isThin = grown.tree.branches[b].radiusMm.front() < thinRadiusMm;
            weightedIndices.insert(weightedIndices.end(), isThin ? 2 : 1, b);
        }
    }
    return weightedIndices.empty()
               ? 0
               : weightedIndices[static_cast<std::size_t>(random.index(static_cast<int>(weightedIndices.size())))];
}

/// Draws which branches are opacified, one flag per branch; the fraction `missingShare` is not. Branches are removed
/// from the ends of the tree, thin ones twice as often, so an opacified branch never has an unopacified parent; the
/// trunk always stays opacified.
std::vector<bool> drawOpacifiedBranches(const GrownTree& grown, double missingShare, CounterRandom& random)
{
    std::vector<bool> opacified(grown.tree.branches.size(), true);
    const auto missing = static_cast<int>(std::lround(missingShare * static_cast<double>(opacified.size())));
    for (int i = 0; i < missing; ++i) {
        const std::size_t branch = drawEndBranch(grown, opacified, random);
        if (branch != 0) {
            opacified[branch] = false;
        }
    }
    return opacified;
}

constexpr double mixingMm = 12.0;   ///< length over which a child reaches its own opacity
constexpr double tipMm = 14.0;   ///< length over which a vessel fades out toward its tip
constexpr double jetMm = 12.0;   ///< length over which the injected jet spreads to the whole lumen of the trunk

/// State of the contrast agent at the start of a path.
struct Inlet {
    double opacity = 1.0;
    double pathMm = 0.0;
};

Inlet inletAt(const ContrastPoint& point)
{
    return {point.opacity, point.pathMm};
}

ContrastPath contrastPathAlong(const VesselBranch& branch, double opacity, const Inlet& inlet)
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

/// Returns the fraction of a child's lumen at `point` outside its parent, so that contrast agent is not counted twice.
double fractionOutside(const VesselBranch& parent, const Eigen::Vector3d& point)
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

/// Reduces the opacity of a vessel toward its tip.
void fadeTip(ContrastPath& path)
{
    const double endMm = path.back().pathMm;
    for (ContrastPoint& point : path) {
        point.opacity *= 0.15 + 0.85 * smoothStep((endMm - point.pathMm) / tipMm);
    }
}

ContrastPath childPath(ContrastPath path, const VesselBranch& parent)
{
    fadeTip(path);
    for (ContrastPoint& point : path) {
        point.opacity *= fractionOutside(parent, point.pointInPatient);
    }
    return path;
}

ContrastPath trunkPath(ContrastPath path)
{
    fadeTip(path);
    for (ContrastPoint& point : path) {
        point.opacity *= 0.1 + 0.9 * smoothStep(point.pathMm / jetMm);
    }
    return path;
}

/// Adds vessels that are not in the tree; each visible branch gets one with probability `share`.
void addExtraVessels(OpacifiedVessels& vessels, double share, int firstId, CounterRandom& random)
{
    const std::vector<VesselBranch> parents = vessels.visible.branches;
    for (std::size_t b = 0; b < parents.size(); ++b) {
        const auto count = static_cast<double>(parents[b].pointsInPatient.size());
        const auto takeoff = static_cast<std::size_t>(random.uniform(0.3, 0.8) * count);
        if (random.uniform() >= share) {
            continue;
        }
        VesselBranch extra = growSideBranch(parents[b], takeoff, random);
        extra.id = firstId++;
        extra.name = "extra";
        const Inlet inlet = inletAt(vessels.paths[b][takeoff]);
        vessels.paths.push_back(childPath(contrastPathAlong(extra, random.uniform(0.3, 1.0), inlet), parents[b]));
        vessels.visible.branches.push_back(std::move(extra));
    }
}

/// Adds a catheter through which the contrast agent flows before it reaches the inlet.
void addCatheter(OpacifiedVessels& vessels, const VesselBranch& trunk, CounterRandom& random)
{
    VesselBranch catheter = makeCatheter(trunk, random);
    const double opacity = random.uniform(0.5, 1.0);
    vessels.paths.push_back(contrastPathAlong(catheter, opacity, {opacity, -catheter.lengthMm()}));
    vessels.catheter.branches.push_back(std::move(catheter));
}

}   // namespace

OpacifiedVessels opacifyVessels(const GrownTree& grown, const DsaOptions& options, CounterRandom& random)
{
    const std::vector<VesselBranch>& branches = grown.tree.branches;
    const std::vector<bool> opacified = drawOpacifiedBranches(grown, options.missingBranchShare, random);
    OpacifiedVessels vessels;
    std::vector<ContrastPath> pathOf(branches.size());   // without fading, as inlets of the children
    for (std::size_t b = 0; b < branches.size(); ++b) {
        const double opacity = random.uniform(b == 0 ? 0.85 : 0.3, 1.0);
        if (!opacified[b]) {
            vessels.missingBranchIds.push_back(branches[b].id);
            continue;
        }
        const Takeoff& takeoff = grown.takeoffs[b];
        if (takeoff.parentIndex < 0) {
            pathOf[b] = contrastPathAlong(branches[b], opacity, {opacity, 0.0});
            vessels.paths.push_back(trunkPath(pathOf[b]));
        } else {
            const auto parent = static_cast<std::size_t>(takeoff.parentIndex);
            pathOf[b] = contrastPathAlong(branches[b], opacity, inletAt(pathOf[parent][takeoff.parentPoint]));
            vessels.paths.push_back(childPath(pathOf[b], branches[parent]));
        }
        vessels.visible.branches.push_back(branches[b]);
        vessels.maxPathMm = std::max(vessels.maxPathMm, pathOf[b].back().pathMm);
    }
    addExtraVessels(vessels, options.extraBranchShare, branches.back().id + 1, random);
    if (random.uniform() < options.catheterProbability) {
        addCatheter(vessels, branches.front(), random);
    }
    return vessels;
}

}   // namespace angiopose::core
