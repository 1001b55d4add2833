#include "tests/benchmark/wire_cases.h"

#include "tests/benchmark/grown_trees.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::benchmarks {
namespace {

constexpr double rad = std::numbers::pi / 180.0;
constexpr double minWireMm = 60.0;
constexpr double startTurnDeg = 2.0;
constexpr double startShiftMm = 5.0;
constexpr double startDepthMm = 10.0;

using Points = std::vector<Eigen::Vector3d>;

/// A path from the inflow toward a leaf.
struct Way {
    Points points;
    std::vector<double> radiusMm;
    std::vector<int> branchIds;   ///< branch id of each point
};

Way segmentTo(const RootedTree& tree, std::size_t leaf)
{
    std::vector<std::size_t> branches;
    for (int at = static_cast<int>(leaf); at >= 0; at = tree.parent[static_cast<std::size_t>(at)]) {
        branches.insert(branches.begin(), static_cast<std::size_t>(at));
    }
    Way way;
    for (std::size_t i = 0; i < branches.size(); ++i) {
        core::VesselBranch branch = tree.tree.branches[branches[i]];
        branch.radiusMm.resize(branch.pointsInPatient.size(), 0.0);
        // Orients the branch toward the next one, or away from the previous one.
        const Eigen::Vector3d& front = branch.pointsInPatient.front();
        const Eigen::Vector3d& back = branch.pointsInPatient.back();
        bool isTurned = false;
        if (!way.points.empty()) {
            isTurned = (back - way.points.back()).norm() < (front - way.points.back()).norm();
        } else if (i + 1 < branches.size()) {
            const core::VesselBranch& next = tree.tree.branches[branches[i + 1]];
            const auto gap = [&](const Eigen::Vector3d& end) {
                return std::min((end - next.pointsInPatient.front()).norm(),
                                (end - next.pointsInPatient.back()).norm());
            };
            isTurned = gap(front) < gap(back);
        }
        if (isTurned) {
            std::ranges::reverse(branch.pointsInPatient);
            std::ranges::reverse(branch.radiusMm);
        }
        way.points.insert(way.points.end(), branch.pointsInPatient.begin(), branch.pointsInPatient.end());
        way.radiusMm.insert(way.radiusMm.end(), branch.radiusMm.begin(), branch.radiusMm.end());
        way.branchIds.insert(way.branchIds.end(), branch.pointsInPatient.size(), branch.id);
    }
    return way;
}

double lengthMm(const Points& points)
{
    core::VesselBranch branch;
    branch.pointsInPatient = points;
    return branch.lengthMm();
}

/// A long random path. Its first part may lie outside the image; its tip is anywhere in the last branch.
Way drawnWay(const RootedTree& tree, ForeignRandom& random)
{
    Way best;
    for (int attempt = 0; attempt < 50 && lengthMm(best.points) < minWireMm; ++attempt) {
        const std::size_t leaf = random.index(tree.parent.size());
        Way way = segmentTo(tree, leaf);
        if (lengthMm(way.points) > lengthMm(best.points)) {
            best = std::move(way);
        }
    }
    const auto count = static_cast<double>(best.points.size());
    const auto from = static_cast<std::ptrdiff_t>(random.uniform(0.0, 0.3) * count);
    const auto to = static_cast<std::ptrdiff_t>(random.uniform(0.75, 1.0) * count);
    Way cut;
    cut.points.assign(best.points.begin() + from, best.points.begin() + to);
    cut.radiusMm.assign(best.radiusMm.begin() + from, best.radiusMm.begin() + to);
    cut.branchIds.assign(best.branchIds.begin() + from, best.branchIds.begin() + to);
    return cut;
}

/// A random walk about the axis in small steps, confined to the lumen and then smoothed toward its neighbors.
Points wandering(const Way& way, ForeignRandom& random)
{
    Points wire = way.points;
    Eigen::Vector3d off = Eigen::Vector3d::Zero();
    const double slackMm = random.uniform(0.3, 1.5);
    for (std::size_t i = 0; i < wire.size(); ++i) {
        const double widthMm = slackMm + random.uniform(0.0, 0.6) * way.radiusMm[i];
        off = 0.95 * off + std::sqrt(1.0 - 0.95 * 0.95) * widthMm *
                               Eigen::Vector3d(random.normal(), random.normal(), random.normal());
        wire[i] += off;
    }
    const auto pulls = 10 + random.index(60);
    for (std::size_t pull = 0; pull < pulls; ++pull) {
        Points straighter = wire;
        for (std::size_t i = 1; i + 1 < wire.size(); ++i) {
            straighter[i] = 0.5 * wire[i] + 0.25 * (wire[i - 1] + wire[i + 1]);
        }
        wire = std::move(straighter);
    }
    return wire;
}

/// Two waves about the axis, averaged along it.
Points swinging(const Way& way, ForeignRandom& random)
{
    const Eigen::Vector3d first = random.direction();
    const Eigen::Vector3d second = random.direction();
    const double sizeMm = random.uniform(0.5, 3.0);
    const double periodA = random.uniform(25.0, 60.0);
    const double periodB = random.uniform(15.0, 40.0);
    const double phase = random.uniform(0.0, 6.28);
    Points swung = way.points;
    double alongMm = 0.0;
    for (std::size_t i = 0; i < swung.size(); ++i) {
        alongMm += i == 0 ? 0.0 : (way.points[i] - way.points[i - 1]).norm();
        const double a = std::sin(2.0 * std::numbers::pi * alongMm / periodA + phase);
        const double b = std::cos(2.0 * std::numbers::pi * alongMm / periodB);
        swung[i] += sizeMm * (0.8 * a * first + 0.6 * b * second);
    }
    const auto reach = static_cast<std::ptrdiff_t>(random.uniform(3.0, 8.0));
    Points wire;
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(swung.size()); ++i) {
        const std::ptrdiff_t low = std::max<std::ptrdiff_t>(0, i - reach);
        const std::ptrdiff_t high = std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(swung.size()) - 1, i + reach);
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (std::ptrdiff_t k = low; k <= high; ++k) {
            mean += swung[static_cast<std::size_t>(k)] / static_cast<double>(high - low + 1);
        }
        wire.push_back(mean);
    }
    return wire;
}

core::RigidTransform drawnView(const core::VesselTree& tree, ForeignRandom& random)
{
    Eigen::Matrix3d front;
    front << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(random.uniform(-30.0, 30.0) * rad, Eigen::Vector3d::UnitX()) *
                                  Eigen::AngleAxisd(random.uniform(-90.0, 90.0) * rad, Eigen::Vector3d::UnitY()))
                                     .toRotationMatrix() *
                                 front;
    return {turn, Eigen::Vector3d(0.0, 0.0, random.uniform(680.0, 800.0)) - turn * core::centroidInPatient(tree)};
}

/// An earlier pose: since then the patient has breathed and moved a little.
core::RigidTransform before(const core::RigidTransform& pose, const Eigen::Vector3d& centroid, ForeignRandom& random)
{
    Eigen::Vector3d turn(random.normal(), random.normal(), random.normal());
    turn *= startTurnDeg * rad;
    const Eigen::Matrix3d rotation =
        turn.norm() > 0.0 ? Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * pose.rotation
                          : pose.rotation;
    const Eigen::Vector3d shift(startShiftMm * random.normal(), startShiftMm * random.normal(),
                                startDepthMm * random.normal());
    return {rotation, pose * centroid + shift - rotation * centroid};
}

/// Adds the width of a guidewire or catheter, which is constant apart from the errors of a tracer.
void addDeviceWidth(core::Curve2d& curve, ForeignRandom random)
{
    const double devicePx = random.uniform(0.18, 1.35) * 6000.0 / 740.0;   // 0.014 inch to 8 French
    double wander = random.normal();
    for (std::size_t i = 0; i < curve.pointsPx.size(); ++i) {
        wander = 0.91 * wander + 0.41 * random.normal();
        curve.radiusPx.push_back(std::max(0.75, devicePx * std::exp(0.15 * wander)));
    }
}

WireCase imaged(const RootedTree& tree, const Way& way, const Points& wire, ForeignRandom& random)
{
    WireCase made;
    made.tree = tree.name;
    made.input.tree = tree.tree;
    made.input.camera = {-6000.0, 6000.0, 511.5, 511.5, 1024, 1024};
    made.cameraFromPatient = drawnView(tree.tree, random);
    made.input.initialCameraFromPatient = before(made.cameraFromPatient, core::centroidInPatient(tree.tree), random);
    core::Curve2d curve;
    double squares = 0.0;
    for (std::size_t i = 0; i < wire.size(); ++i) {
        const auto pixel = core::project(made.input.camera, made.cameraFromPatient * wire[i]);
        if (pixel && pixel->minCoeff() >= 0.0 && pixel->maxCoeff() <= 1023.0) {
            curve.pointsPx.push_back(*pixel + 0.7 * Eigen::Vector2d(random.normal(), random.normal()));
            made.axisInPatient.push_back(way.points[i]);
            if (made.branchIds.empty() || made.branchIds.back() != way.branchIds[i]) {
                made.branchIds.push_back(way.branchIds[i]);
            }
            squares += (wire[i] - way.points[i]).squaredNorm();
        }
    }
    if (random.uniform() < 0.5) {
        std::ranges::reverse(curve.pointsPx);
    }
    addDeviceWidth(curve, ForeignRandom(7'000'003 + curve.pointsPx.size()));
    made.offAxisMm = std::sqrt(squares / std::max<double>(1.0, static_cast<double>(curve.pointsPx.size())));
    made.input.target.curves.push_back(std::move(curve));
    return made;
}

}   // namespace

WireCase madeUpWireCase(std::uint64_t number)
{
    ForeignRandom random(90000 + number);
    const RootedTree tree = grownTree(number / 4);
    const Way way = drawnWay(tree, random);
    return imaged(tree, way, wandering(way, random), random);
}

WireCase judgingWireCase(const RootedTree& tree, std::uint64_t trial)
{
    ForeignRandom random(50000 + trial);
    const Way way = drawnWay(tree, random);
    return imaged(tree, way, swinging(way, random), random);
}

}   // namespace angiopose::benchmarks
