#include "tests/benchmark/grown_trees.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::benchmarks {
namespace {

constexpr double stepMm = 1.2;

/// Common properties of the branches of one tree.
struct ToolPreference {
    int generations = 4;
    double lengthMm = 25.0;   ///< of a root branch
    double shrink = 0.85;   ///< length ratio from generation to generation
    double wander = 0.1;   ///< rad per step
    double minAngle = 0.3, maxAngle = 0.9;
    double threeShare = 0.1;   ///< share of trifurcations among the branching points
    double endShare = 0.15;   ///< share of branches that end early
};

ToolPreference drawnPreference(ForeignRandom& random)
{
    ToolPreference preference;
    preference.generations = 3 + static_cast<int>(random.index(4));
    preference.lengthMm = random.uniform(18.0, 45.0);
    preference.shrink = random.uniform(0.65, 0.95);
    preference.wander = random.uniform(0.03, 0.18);
    preference.maxAngle = random.uniform(0.6, 1.3);
    preference.threeShare = random.uniform(0.0, 0.25);
    preference.endShare = random.uniform(0.05, 0.3);
    return preference;
}

class Growing {
public:
    Growing(RootedTree& tree, const ToolPreference& preference, ForeignRandom& random)
        : tree_(tree), preference_(preference), random_(random)
    {
    }

    void grow(int parent, const Eigen::Vector3d& from, Eigen::Vector3d heading, int generation)
    {
        core::VesselBranch branch;
        branch.id = static_cast<int>(tree_.tree.branches.size()) + 1;
        branch.pointsInPatient = wandered(from, heading, generation);
        branch.radiusMm.assign(branch.pointsInPatient.size(), 2.4 * std::pow(0.78, generation));
        const Eigen::Vector3d end = branch.pointsInPatient.back();
        const int own = static_cast<int>(tree_.tree.branches.size());
        tree_.tree.branches.push_back(std::move(branch));
        tree_.parent.push_back(parent);
        if (generation + 1 >= preference_.generations || (generation > 1 && random_.uniform() < preference_.endShare)) {
            return;
        }
        const int children = random_.uniform() < preference_.threeShare ? 3 : 2;
        const double first = random_.uniform(0.0, 2.0 * std::numbers::pi);
        for (int child = 0; child < children; ++child) {
            const double around = first + 2.0 * std::numbers::pi * (child + random_.uniform(-0.1, 0.1)) / children;
            grow(own, end, leaving(heading, around), generation + 1);
        }
    }

private:
    std::vector<Eigen::Vector3d> wandered(const Eigen::Vector3d& from, Eigen::Vector3d& heading, int generation)
    {
        const double lengthMm =
            preference_.lengthMm * std::pow(preference_.shrink, generation) * random_.uniform(0.5, 1.6);
        std::vector<Eigen::Vector3d> points{from};
        Eigen::Vector3d turn = Eigen::Vector3d::Zero();
        for (int left = std::max(3, static_cast<int>(lengthMm / stepMm)); left > 0; --left) {
            turn = 0.85 * turn + preference_.wander * random_.direction();
            heading = (heading + 0.3 * turn).normalized();
            points.push_back(points.back() + stepMm * heading);
        }
        return points;
    }

    Eigen::Vector3d leaving(const Eigen::Vector3d& heading, double around)
    {
        const Eigen::Vector3d side = heading.unitOrthogonal();
        const Eigen::Vector3d axis = Eigen::AngleAxisd(around, heading) * side;
        return Eigen::AngleAxisd(random_.uniform(preference_.minAngle, preference_.maxAngle), axis) * heading;
    }

    RootedTree& tree_;
    const ToolPreference& preference_;
    ForeignRandom& random_;
};

core::VesselTree inWaves(const core::VesselTree& tree, double sizeMm, ForeignRandom& random)
{
    struct Wave {
        Eigen::Vector3d vector, amplitude;
        double phase;
    };
    std::vector<Wave> waves(6 + random.index(20));
    for (Wave& wave : waves) {
        const double lengthMm = 30.0 * std::pow(20.0, random.uniform());
        wave = {2.0 * std::numbers::pi / lengthMm * random.direction(), random.direction(), random.uniform(0.0, 6.283)};
    }
    core::VesselTree moved = tree;
    double squares = 0.0;
    std::vector<Eigen::Vector3d> shifts;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            Eigen::Vector3d shift = Eigen::Vector3d::Zero();
            for (const Wave& wave : waves) {
                shift += std::cos(wave.vector.dot(point) + wave.phase) * wave.amplitude;
            }
            squares += shift.squaredNorm();
            shifts.push_back(shift);
        }
    }
    const double factor = sizeMm / std::sqrt(squares / static_cast<double>(shifts.size()));
    std::size_t next = 0;
    for (core::VesselBranch& branch : moved.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            point += factor * shifts[next++];
        }
    }
    return moved;
}

/// Rotates one subtree about its first point until its farthest point has moved by `sizeMm`.
core::VesselTree partTurned(const RootedTree& tree, double sizeMm, ForeignRandom& random)
{
    const std::vector<std::size_t> part = tree.fedThrough(random.index(tree.parent.size()));
    const Eigen::Vector3d hinge = tree.tree.branches[part.front()].pointsInPatient.front();
    const Eigen::Vector3d axis = random.direction();
    double farthest = 1.0;
    for (const std::size_t branch : part) {
        for (const Eigen::Vector3d& point : tree.tree.branches[branch].pointsInPatient) {
            farthest = std::max(farthest, axis.cross(point - hinge).norm());
        }
    }
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(sizeMm / farthest, axis).toRotationMatrix();
    core::VesselTree moved = tree.tree;
    for (const std::size_t branch : part) {
        for (Eigen::Vector3d& point : moved.branches[branch].pointsInPatient) {
            point = hinge + turn * (point - hinge);
        }
    }
    return moved;
}

}   // namespace

RootedTree grownTree(std::uint64_t number)
{
    ForeignRandom random(77'003 + number);
    RootedTree tree;
    tree.name = "grown " + std::to_string(number);
    const ToolPreference preference = drawnPreference(random);
    const std::size_t roots = 1 + random.index(3);
    for (std::size_t root = 0; root < roots; ++root) {
        const Eigen::Vector3d from = 40.0 * (random.uniform() - 0.5) * Eigen::Vector3d::UnitX() +
                                     30.0 * static_cast<double>(root) * Eigen::Vector3d::UnitY();
        const Eigen::Vector3d up = (Eigen::Vector3d::UnitZ() + 0.4 * random.direction()).normalized();
        Growing(tree, preference, random).grow(-1, from, up, 0);
    }
    return tree;
}

core::VesselTree movedTree(const RootedTree& tree, ForeignRandom& random)
{
    const double form = random.uniform();
    const double sizeMm = 0.3 * std::pow(25.0, random.uniform());
    if (form < 0.5) {
        return tree.tree;
    }
    return form < 0.85 ? inWaves(tree.tree, sizeMm, random) : partTurned(tree, sizeMm, random);
}

}   // namespace angiopose::benchmarks
