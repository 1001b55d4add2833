#include "core/simulation/grow_tree.h"

#include "core/simulation/murray_radii.h"
#include "core/simulation/smooth_path.h"
#include "core/vessel/polyline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace angiopose::core {
namespace {

// The tree grows at this fixed size and is then scaled to the requested extent.
constexpr double growthHalfExtentMm = 90.0;
constexpr double takeoffMarginMm = 9.0;   ///< distance from ends and other takeoffs within which no branch takes off
constexpr double minReachMm = 22.0;   ///< minimum straight-line length of a branch before scaling
constexpr int candidateCount = 60;

/// Random properties that distinguish the anatomies of different seeds.
struct Anatomy {
    Eigen::Vector3d halfAxesMm;
    double hollowness;   ///< 0: the vessels fill the organ; 1: they lie on its surface (heart, brain)
    double tortuosity;
    double upward;   ///< +1 if the blood flows toward the head, −1 if toward the feet
};

Anatomy drawAnatomy(CounterRandom& random)
{
    Anatomy anatomy;
    const double width = random.uniform(0.75, 1.0);
    const double thickness = random.uniform(0.6, 0.95);
    anatomy.halfAxesMm = growthHalfExtentMm * Eigen::Vector3d(width, thickness, 1.0);
    anatomy.hollowness = random.uniform();
    anatomy.tortuosity = random.uniform(0.8, 1.8);
    anatomy.upward = random.uniform() < 0.5 ? 1.0 : -1.0;
    return anatomy;
}

Eigen::Vector3d randomDirection(CounterRandom& random)
{
    const double x = random.normal();
    const double y = random.normal();
    const double z = random.normal();
    return (Eigen::Vector3d(x, y, z) + Eigen::Vector3d(0.0, 0.0, 1e-9)).normalized();
}

Eigen::Vector3d randomPointInOrgan(const Anatomy& anatomy, CounterRandom& random)
{
    const Eigen::Vector3d direction = randomDirection(random);
    const double filled = std::cbrt(random.uniform());
    const double radius = (1.0 - anatomy.hollowness) * filled + anatomy.hollowness * random.uniform(0.85, 1.0);
    return radius * anatomy.halfAxesMm.cwiseProduct(direction);
}

double distanceToTree(const VesselTree& tree, const Eigen::Vector3d& place)
{
    double nearest = std::numeric_limits<double>::max();
    for (const VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            nearest = std::min(nearest, (point - place).squaredNorm());
        }
    }
    return std::sqrt(nearest);
}

/// Returns the random candidate position farthest from the tree; this farthest-point sampling fills the organ evenly.
Eigen::Vector3d emptiestPosition(const VesselTree& tree, const Anatomy& anatomy, CounterRandom& random)
{
    Eigen::Vector3d best = Eigen::Vector3d::Zero();
    double bestDistance = -1.0;
    for (int i = 0; i < candidateCount; ++i) {
        const Eigen::Vector3d place = randomPointInOrgan(anatomy, random);
        const double distance = distanceToTree(tree, place);
        if (distance > bestDistance) {
            bestDistance = distance;
            best = place;
        }
    }
    return best;
}

bool isFree(const GrownTree& grown, std::size_t branch, std::size_t point)
{
    const auto margin = static_cast<std::size_t>(takeoffMarginMm);   // points are 1 mm apart before scaling
    const std::size_t count = grown.tree.branches[branch].pointsInPatient.size();
    if (point < margin || point + margin >= count) {
        return false;
    }
    return std::none_of(grown.takeoffs.begin(), grown.takeoffs.end(), [&](const Takeoff& other) {
        const std::size_t apart = std::max(other.parentPoint, point) - std::min(other.parentPoint, point);
        return other.parentIndex == static_cast<int>(branch) && apart < margin;
    });
}

int generationOf(const GrownTree& grown, std::size_t branch)
{
    int generation = 0;
    for (int parent = grown.takeoffs[branch].parentIndex; parent >= 0; ++generation) {
        parent = grown.takeoffs[static_cast<std::size_t>(parent)].parentIndex;
    }
    return generation;
}

/// Returns the takeoff with the lowest cost for a branch to `place`. The cost is the path length plus penalties for
/// deviating from the parent's direction and for late generations; it results in branching angles near 40°.
Takeoff cheapestTakeoff(const GrownTree& grown, const Eigen::Vector3d& place)
{
    Takeoff best;
    double bestCost = std::numeric_limits<double>::max();
    for (std::size_t b = 0; b < grown.tree.branches.size(); ++b) {
        const std::vector<Eigen::Vector3d>& points = grown.tree.branches[b].pointsInPatient;
        const std::vector<Eigen::Vector3d> tangents = polylineTangents<3>(points, 3);
        const double generationFactor = 1.0 + 0.2 * generationOf(grown, b);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Eigen::Vector3d offset = place - points[i];
            const double cost = generationFactor * (4.0 * offset.norm() - 3.0 * tangents[i].dot(offset));
            if (cost < bestCost && offset.norm() > minReachMm && isFree(grown, b, i)) {
                bestCost = cost;
                best = {static_cast<int>(b), i};
            }
        }
    }
    return best;
}

std::vector<Eigen::Vector3d> growTrunk(const Anatomy& anatomy, CounterRandom& random)
{
    const Eigen::Vector3d up(0.0, 0.0, anatomy.upward);
    const Eigen::Vector3d sideways = anatomy.halfAxesMm.cwiseProduct(randomDirection(random));
    PathPlan plan;
    plan.start = -anatomy.halfAxesMm.z() * up + 0.15 * sideways;
    plan.end = random.uniform(0.55, 0.8) * anatomy.halfAxesMm.z() * up + random.uniform(0.4, 0.8) * sideways;
    plan.startDirection = (up + 0.7 * randomDirection(random)).normalized();
    plan.endDirection = (up + 0.9 * randomDirection(random)).normalized();
    plan.tortuosity = anatomy.tortuosity;
    return smoothPath(plan, random);
}

/// Adds one branch; returns false if no position was reachable.
bool growBranch(GrownTree& grown, const Anatomy& anatomy, CounterRandom& random)
{
    const Eigen::Vector3d place = emptiestPosition(grown.tree, anatomy, random);
    const Takeoff takeoff = cheapestTakeoff(grown, place);
    if (takeoff.parentIndex < 0) {
        return false;
    }
    const std::vector<Eigen::Vector3d>& parent =
        grown.tree.branches[static_cast<std::size_t>(takeoff.parentIndex)].pointsInPatient;
    PathPlan plan;
    plan.start = parent[takeoff.parentPoint];
    plan.end = place;
    const Eigen::Vector3d offset = (plan.end - plan.start).normalized();
    plan.startDirection = (0.5 * polylineTangents<3>(parent, 3)[takeoff.parentPoint] + offset).normalized();
    plan.endDirection = (offset + 0.4 * randomDirection(random)).normalized();
    plan.tortuosity = anatomy.tortuosity;

    VesselBranch branch;
    branch.id = static_cast<int>(grown.tree.branches.size()) + 1;
    branch.pointsInPatient = smoothPath(plan, random);
    grown.tree.branches.push_back(std::move(branch));
    grown.takeoffs.push_back(takeoff);
    return true;
}

/// Names the branches: Trunk; A, B, … for its children; A1, A2, … for their children; A1.1, … for later generations.
void nameBranches(GrownTree& grown)
{
    std::vector<int> children(grown.tree.branches.size(), 0);
    for (std::size_t b = 0; b < grown.tree.branches.size(); ++b) {
        const int parent = grown.takeoffs[b].parentIndex;
        if (parent < 0) {
            grown.tree.branches[b].name = "Trunk";
            continue;
        }
        const int rank = children[static_cast<std::size_t>(parent)]++;
        const int generation = generationOf(grown, b);
        std::string& name = grown.tree.branches[b].name;
        if (generation == 1 && rank < 26) {
            name = static_cast<char>('A' + rank);
            continue;
        }
        name = grown.tree.branches[static_cast<std::size_t>(parent)].name;
        name += generation == 2 ? "" : ".";
        name += std::to_string(rank + 1);
    }
}

/// Centers the bounding box at the origin and scales its longest side to `extentMm`.
void fitIntoBox(VesselTree& tree, double extentMm)
{
    Eigen::AlignedBox3d box;
    for (const VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            box.extend(point);
        }
    }
    const double scale = extentMm / box.sizes().maxCoeff();
    for (VesselBranch& branch : tree.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            point = scale * (point - box.center());
        }
    }
}

/// Resamples the branches to the final spacing and moves takeoffs to the nearest new point.
void resampleTo(GrownTree& grown, double spacingMm)
{
    for (std::size_t b = 0; b < grown.tree.branches.size(); ++b) {
        Takeoff& takeoff = grown.takeoffs[b];
        if (takeoff.parentIndex < 0) {
            continue;
        }
        const auto parent = static_cast<std::size_t>(takeoff.parentIndex);
        const double oldLast = static_cast<double>(grown.tree.branches[parent].pointsInPatient.size() - 1);
        const double newLast = std::max(1.0, std::round(grown.tree.branches[parent].lengthMm() / spacingMm));
        takeoff.parentPoint =
            static_cast<std::size_t>(std::round(static_cast<double>(takeoff.parentPoint) * newLast / oldLast));
    }
    grown.tree = resampled(grown.tree, spacingMm);
}

}   // namespace

GrownTree growTree(std::uint64_t seed, const TreeOptions& options)
{
    CounterRandom random(seed);
    const Anatomy anatomy = drawAnatomy(random);
    GrownTree grown;
    grown.tree.branches.push_back({1, "", growTrunk(anatomy, random), {}});
    grown.takeoffs.emplace_back();
    // In a crowded tree, a position may have no free takeoff; other positions are then tried, up to a limit.
    for (int attempt = 0; attempt < 20 * options.branchCount; ++attempt) {
        if (static_cast<int>(grown.tree.branches.size()) >= options.branchCount) {
            break;
        }
        growBranch(grown, anatomy, random);
    }
    nameBranches(grown);
    fitIntoBox(grown.tree, options.extentMm);
    resampleTo(grown, options.pointSpacingMm);
    assignMurrayRadii(grown, options.rootRadiusMm);
    return grown;
}

VesselTree simulateTree(std::uint64_t seed, const TreeOptions& options)
{
    return growTree(seed, options).tree;
}

}   // namespace angiopose::core
