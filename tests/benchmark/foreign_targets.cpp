#include "tests/benchmark/foreign_targets.h"

#include "tests/benchmark/wide_vessel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace angiopose::benchmarks {
namespace {

constexpr double sourceToDetectorMm = 1100.0;
constexpr double sourceToPatientMm = 720.0;
constexpr double pixelMm = 0.31;
constexpr int imagePx = 960;
constexpr double stepPx = 1.37;   // never the tree's own samples
constexpr double jitterPx = 0.5;
constexpr double jitterReachPx = 15.0;
constexpr double rad = std::numbers::pi / 180.0;

using Pixels = std::vector<Eigen::Vector2d>;

/// Pinhole by hand: the project's projection is what is to be judged.
Eigen::Vector2d pixelOf(const Eigen::Vector3d& inCamera)
{
    const double magnified = sourceToDetectorMm / inCamera.z() / pixelMm;
    const double middle = 0.5 * (imagePx - 1);
    return {middle - magnified * inCamera.x(), middle + magnified * inCamera.y()};
}

core::ProjectionCamera camera()
{
    const double focalPx = sourceToDetectorMm / pixelMm;
    const double middle = 0.5 * (imagePx - 1);
    return {-focalPx, focalPx, middle, middle, imagePx, imagePx};
}

bool isInside(const Eigen::Vector2d& pixel)
{
    return pixel.minCoeff() >= -0.5 && pixel.maxCoeff() < imagePx - 0.5;
}

/// Every `stepPx` along a polyline, from a random phase on.
Pixels walked(const Pixels& curve, ForeignRandom& random)
{
    Pixels points;
    double toNext = random.uniform(0.0, stepPx);
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const Eigen::Vector2d way = curve[i] - curve[i - 1];
        const double length = way.norm();
        double at = toNext;
        for (; at < length; at += stepPx) {
            points.emplace_back(curve[i - 1] + at / length * way);
        }
        toNext = at - length;
    }
    return points;
}

/// As a tracer leaves it: off by what neighbours share, rounded to pixels, cut at the image's edges.
Pixels traced(const Pixels& curve, ForeignRandom& random)
{
    const double kept = std::exp(-stepPx / jitterReachPx);
    Eigen::Vector2d jitter(random.normal(), random.normal());
    Pixels points;
    for (const Eigen::Vector2d& point : walked(curve, random)) {
        jitter = kept * jitter + std::sqrt(1.0 - kept * kept) * Eigen::Vector2d(random.normal(), random.normal());
        const Eigen::Vector2d off = point + jitterPx * jitter;
        if (isInside(off)) {
            points.emplace_back(std::round(off.x()), std::round(off.y()));
        }
    }
    return points;
}

/// A vessel that the tree does not have.
Pixels foreignCurve(ForeignRandom& random)
{
    Eigen::Vector2d at(random.uniform(0.15, 0.85) * imagePx, random.uniform(0.15, 0.85) * imagePx);
    double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
    double bend = 0.0;
    Pixels curve;
    for (int steps = 40 + static_cast<int>(random.index(80)); steps > 0; --steps) {
        curve.push_back(at);
        bend = 0.9 * bend + 0.02 * random.normal();
        heading += bend;
        at += 3.0 * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    }
    return curve;
}

std::vector<std::size_t> allOf(const RootedTree& tree)
{
    std::vector<std::size_t> all(tree.parent.size());
    for (std::size_t branch = 0; branch < all.size(); ++branch) {
        all[branch] = branch;
    }
    return all;
}

/// A subtree whose share of the tree's length lies in between; the nearest to it when none does.
std::vector<std::size_t> territory(const RootedTree& tree, double least, double most, ForeignRandom& random)
{
    const double whole = tree.lengthMm(allOf(tree));
    std::vector<std::vector<std::size_t>> fitting;
    std::vector<std::size_t> nearest;
    double nearestOff = 2.0;
    for (std::size_t branch = 0; branch < tree.parent.size(); ++branch) {
        std::vector<std::size_t> fed = tree.fedThrough(branch);
        const double share = tree.lengthMm(fed) / whole;
        if (share >= least && share <= most) {
            fitting.push_back(fed);
        }
        if (const double off = std::abs(share - 0.5 * (least + most)); off < nearestOff) {
            nearestOff = off;
            nearest = std::move(fed);
        }
    }
    return fitting.empty() ? nearest : fitting[random.index(fitting.size())];
}

std::vector<std::size_t> twoTerritories(const RootedTree& tree, ForeignRandom& random)
{
    std::vector<std::size_t> both = territory(tree, 0.08, 0.3, random);
    for (int tries = 0; tries < 50; ++tries) {
        const std::vector<std::size_t> other = territory(tree, 0.08, 0.3, random);
        std::vector<std::size_t> common;
        std::set_intersection(both.begin(), both.end(), other.begin(), other.end(), std::back_inserter(common));
        if (common.empty()) {
            both.insert(both.end(), other.begin(), other.end());
            break;
        }
    }
    std::sort(both.begin(), both.end());
    return both;
}

std::vector<std::size_t> withoutLeaves(const RootedTree& tree, double share, ForeignRandom& random)
{
    std::vector<std::size_t> kept;
    for (const std::size_t branch : allOf(tree)) {
        if (!tree.isLeaf(branch) || random.uniform() >= share) {
            kept.push_back(branch);
        }
    }
    return kept;
}

std::vector<std::size_t> wayToAnEnd(const RootedTree& tree, ForeignRandom& random)
{
    std::size_t end = random.index(tree.parent.size());
    while (!tree.isLeaf(end)) {
        end = random.index(tree.parent.size());
    }
    std::vector<std::size_t> way;
    for (int at = static_cast<int>(end); at >= 0; at = tree.parent[static_cast<std::size_t>(at)]) {
        way.push_back(static_cast<std::size_t>(at));
    }
    return {way.rbegin(), way.rend()};
}

std::vector<std::size_t> filledIn(const RootedTree& tree, ForeignScene scene, ForeignRandom& random)
{
    switch (scene) {
        case ForeignScene::OneTerritory:
        case ForeignScene::OtherTerritory:
            return territory(tree, 0.1, 0.5, random);
        case ForeignScene::TwoTerritories:
            return twoTerritories(tree, random);
        case ForeignScene::OneVessel:
            return wayToAnEnd(tree, random);
        case ForeignScene::LeavesMissing:
            return withoutLeaves(tree, 0.2, random);
        default:
            return allOf(tree);
    }
}

core::RigidTransform viewTurnedBy(double leftMost, double rightMost, const RootedTree& tree, ForeignRandom& random)
{
    // Looking from the front, the patient's head up; then turned as a C-arm is.
    Eigen::Matrix3d front;
    front << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
    const Eigen::Matrix3d turned =
        (Eigen::AngleAxisd(random.uniform(-30.0, 30.0) * rad, Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(random.uniform(leftMost, rightMost) * rad, Eigen::Vector3d::UnitY()))
            .toRotationMatrix() *
        front;
    const Eigen::Vector3d place(random.uniform(-8.0, 8.0), random.uniform(-8.0, 8.0),
                                sourceToPatientMm + random.uniform(-40.0, 40.0));
    return {turned, place - turned * core::centroidInPatient(tree.tree)};
}

core::RigidTransform drawnView(const RootedTree& tree, ForeignRandom& random)
{
    return viewTurnedBy(-90.0, 90.0, tree, random);
}

/// From either side, within 15°.
core::RigidTransform drawnSideView(const RootedTree& tree, ForeignRandom& random)
{
    const double side = random.uniform() < 0.5 ? -90.0 : 90.0;
    return viewTurnedBy(side - 15.0, side + 15.0, tree, random);
}

core::RigidTransform displacedStart(const core::RigidTransform& truth, const Eigen::Vector3d& centroid,
                                    ForeignRandom& random)
{
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(random.uniform(0.0, 15.0) * rad, random.direction()).toRotationMatrix();
    const double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double acrossMm = 30.0 * std::sqrt(random.uniform());
    const Eigen::Vector3d shift(acrossMm * std::cos(heading), acrossMm * std::sin(heading),
                                random.uniform(-50.0, 50.0));
    const Eigen::Matrix3d rotation = turn * truth.rotation;
    return {rotation, truth * centroid + shift - rotation * centroid};
}

void shuffle(Pixels& points, ForeignRandom& random)
{
    for (std::size_t left = points.size(); left > 1; --left) {
        std::swap(points[left - 1], points[random.index(left)]);
    }
}

/// Row by row, each once: what is read from a mask.
Pixels asPixels(const Pixels& points)
{
    std::set<std::pair<double, double>> rows;
    for (const Eigen::Vector2d& point : points) {
        rows.insert({point.y(), point.x()});
    }
    Pixels pixels;
    for (const auto& [v, u] : rows) {
        pixels.emplace_back(u, v);
    }
    return pixels;
}

core::Centerline2d handedOver(std::vector<Pixels> curves, ForeignScene scene, ForeignRandom& random)
{
    if (scene == ForeignScene::ShuffledPoints || scene == ForeignScene::SkeletonPixels) {
        Pixels all;
        for (const Pixels& curve : curves) {
            all.insert(all.end(), curve.begin(), curve.end());
        }
        curves = {scene == ForeignScene::SkeletonPixels ? asPixels(all) : all};
    }
    core::Centerline2d target;
    for (Pixels& curve : curves) {
        if (scene == ForeignScene::ShuffledPoints || scene == ForeignScene::ShuffledRows) {
            shuffle(curve, random);
        }
        if (!curve.empty()) {
            target.curves.push_back({static_cast<int>(target.curves.size()), std::move(curve), {}});
        }
    }
    return target;
}

std::vector<Pixels> seen(const RootedTree& shown, const std::vector<std::size_t>& filled,
                         const core::RigidTransform& view, ForeignRandom& random)
{
    std::vector<Pixels> curves;
    for (const std::size_t branch : filled) {
        Pixels projected;
        for (const Eigen::Vector3d& point : shown.tree.branches[branch].pointsInPatient) {
            projected.push_back(pixelOf(view * point));
        }
        curves.push_back(traced(projected, random));
    }
    return curves;
}

/// Short wriggling curves, or points one by one.
std::vector<Pixels> noVessels(ForeignScene scene, ForeignRandom& random)
{
    const bool isCurves = scene == ForeignScene::Scribbles;
    std::vector<Pixels> found(isCurves ? 2000 : 20'000);
    for (Pixels& curve : found) {
        Eigen::Vector2d at(random.uniform(0.0, imagePx - 1.0), random.uniform(0.0, imagePx - 1.0));
        double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
        for (int left = isCurves ? 66 : 1; left > 0 && at.minCoeff() >= 0.0 && at.maxCoeff() < imagePx; --left) {
            curve.push_back(at);
            heading += 0.15 * random.normal();
            at += stepPx * Eigen::Vector2d(std::cos(heading), std::sin(heading));
        }
    }
    return found;
}

/// Where the filled vessels run and how wide the image shows them.
struct WideLine {
    Pixels at;
    std::vector<double> radiusPx;

    /// Of the vessel at a pixel; nothing beside the vessels.
    double widthAt(const Eigen::Vector2d& pixel) const
    {
        double nearest = 25.0;   // px²
        double radius = 0.0;
        for (std::size_t i = 0; i < at.size(); ++i) {
            if (const double squared = (at[i] - pixel).squaredNorm(); squared < nearest) {
                nearest = squared;
                radius = radiusPx[i];
            }
        }
        return radius;
    }
};

WideLine wideLines(const RootedTree& shown, const std::vector<std::size_t>& filled, const core::RigidTransform& view)
{
    WideLine lines;
    for (const std::size_t branch : filled) {
        const core::VesselBranch& vessel = shown.tree.branches[branch];
        for (std::size_t i = 0; i < vessel.radiusMm.size(); ++i) {
            const Eigen::Vector3d inCamera = view * vessel.pointsInPatient[i];
            lines.at.push_back(pixelOf(inCamera));
            lines.radiusPx.push_back(vessel.radiusMm[i] * sourceToDetectorMm / inCamera.z() / pixelMm);
        }
    }
    return lines;
}

/// Widths as a tracer tells them: all of them too wide or too narrow by some share, each by another that neighbours
/// have in common, none below a pixel and a half.
void addWidths(core::Centerline2d& target, const WideLine& lines, ForeignRandom random)
{
    constexpr double narrowestPx = 0.75;
    constexpr double keptAlong = 0.91;
    const double bias = std::exp(0.12 * random.normal());
    for (core::Curve2d& curve : target.curves) {
        const double foreignPx = random.uniform(1.0, 5.0);
        double wander = random.normal();
        for (const Eigen::Vector2d& pixel : curve.pointsPx) {
            wander = keptAlong * wander + std::sqrt(1.0 - keptAlong * keptAlong) * random.normal();
            const double ownPx = lines.widthAt(pixel);
            const double trueness = bias * std::exp(0.2 * wander);
            curve.radiusPx.push_back(std::max(narrowestPx, trueness * (ownPx > 0.0 ? ownPx : foreignPx)));
        }
    }
}

/// The gantry turned about the isocentre; `degrees` to the side.
core::RigidTransform turnedGantry(double degrees)
{
    const Eigen::Vector3d isocentre(0.0, 0.0, sourceToPatientMm);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(degrees * rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
    return {turn, isocentre - turn * isocentre};
}

/// What a header's rounding and a sagging gantry make of a pose.
core::RigidTransform misjudged(const core::RigidTransform& pose, const Eigen::Vector3d& centroid, ForeignRandom& random)
{
    const Eigen::Vector3d turn(random.normal(), random.normal(), random.normal());
    const Eigen::Vector3d shift(random.normal(), random.normal(), random.normal());
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(0.25 * rad * turn.norm(), turn.normalized()).toRotationMatrix() * pose.rotation;
    return {rotation, pose * centroid + 0.75 * shift - rotation * centroid};
}

/// Of a carotid the image shows all, of what leaves it half, and vessels beside it that the tree does not have.
ForeignCase makeWideCase(const RootedTree& from, std::size_t tree, std::uint64_t trial)
{
    constexpr int vesselsOfOthers = 8;
    ForeignRandom random(5801 * trial + 103 * tree + 17);
    const WideVesselTree made = withWideVessel(from);
    const core::RigidTransform view = drawnSideView(made.tree, random);
    ForeignCase result;
    result.truth = view;
    result.filled = made.wide;
    for (const std::size_t branch : made.beside) {
        if (random.uniform() < 0.5) {
            result.filled.push_back(branch);
        }
    }
    std::vector<Pixels> curves = seen(made.tree, result.filled, view, random);
    for (int left = vesselsOfOthers; left > 0; --left) {
        curves.push_back(traced(foreignCurve(random), random));
        result.foreignCurves += curves.back().empty() ? 0 : 1;
    }
    result.input.tree = made.tree.tree;
    result.input.camera = camera();
    result.input.target = handedOver(std::move(curves), ForeignScene::WideVessel, random);
    result.input.initialCameraFromPatient = displacedStart(view, core::centroidInPatient(made.tree.tree), random);
    addWidths(result.input.target, wideLines(made.tree, result.filled, view),
              ForeignRandom(104'729 * trial + 307 * tree + 7));
    return result;
}

}   // namespace

ForeignCase makeForeignCase(const std::vector<RootedTree>& trees, std::size_t tree, ForeignScene scene,
                            std::uint64_t trial)
{
    if (scene == ForeignScene::WideVessel) {
        return makeWideCase(trees[tree], tree, trial);
    }
    ForeignRandom random(7919 * trial + 101 * tree + 13);
    const bool isOther = scene >= ForeignScene::OtherPatient;
    const RootedTree& shown = trees[isOther ? (tree + 1) % trees.size() : tree];
    const core::RigidTransform view = drawnView(shown, random);
    const std::vector<std::size_t> filled = filledIn(shown, scene, random);
    std::vector<Pixels> curves =
        scene >= ForeignScene::Scribbles ? noVessels(scene, random) : seen(shown, filled, view, random);
    for (int extra = scene == ForeignScene::LeavesMissing ? 5 : 0; extra > 0; --extra) {
        curves.push_back(traced(foreignCurve(random), random));
    }
    ForeignCase result;
    const Eigen::Vector3d centroid = core::centroidInPatient(trees[tree].tree);
    result.truth = {view.rotation, view * core::centroidInPatient(shown.tree) - view.rotation * centroid};
    result.filled = isOther ? std::vector<std::size_t>() : filled;
    result.input.tree = trees[tree].tree;
    result.input.camera = camera();
    result.input.target = handedOver(std::move(curves), scene, random);
    result.input.initialCameraFromPatient = displacedStart(result.truth, centroid, random);
    const bool isPoints = scene == ForeignScene::ShuffledPoints || scene == ForeignScene::SkeletonPixels;
    if (!isPoints && scene < ForeignScene::Scribbles) {
        addWidths(result.input.target, wideLines(shown, filled, view), ForeignRandom(104'729 * trial + 307 * tree + 5));
    }
    return result;
}

std::array<ForeignCase, 2> makeForeignPair(const std::vector<RootedTree>& trees, std::size_t tree, std::uint64_t trial)
{
    ForeignRandom random(6007 * trial + 211 * tree + 29);
    const RootedTree& shown = trees[tree];
    const Eigen::Vector3d centroid = core::centroidInPatient(shown.tree);
    const core::RigidTransform first = drawnView(shown, random);
    const core::RigidTransform start = displacedStart(first, centroid, random);
    const core::RigidTransform secondFromFirst = turnedGantry(60.0);
    const core::RigidTransform told = misjudged(secondFromFirst, first * centroid, random);
    std::array<ForeignCase, 2> pair;
    for (std::size_t k = 0; k < 2; ++k) {
        const core::RigidTransform view = k == 0 ? first : secondFromFirst * first;
        pair[k].truth = view;
        pair[k].filled = allOf(shown);
        pair[k].input.tree = shown.tree;
        pair[k].input.camera = camera();
        pair[k].input.target = handedOver(seen(shown, pair[k].filled, view, random), ForeignScene::WholeTree, random);
        pair[k].input.initialCameraFromPatient = k == 0 ? start : told * start;
    }
    return pair;
}

ForeignError errorOf(const ForeignCase& asked, const core::RigidTransform& answer)
{
    ForeignError error;
    double count = 0.0;
    for (const std::size_t branch : asked.filled) {
        for (const Eigen::Vector3d& point : asked.input.tree.branches[branch].pointsInPatient) {
            const Eigen::Vector3d there = asked.truth * point;
            const Eigen::Vector3d off = answer * point - there;
            error.spaceMm += off.norm();
            error.inPlaneMm += off.cross(there.normalized()).norm();
            count += 1.0;
        }
    }
    error.spaceMm /= std::max(1.0, count);
    error.inPlaneMm /= std::max(1.0, count);
    error.turnDeg = Eigen::AngleAxisd(answer.rotation.transpose() * asked.truth.rotation).angle() / rad;
    return error;
}

}   // namespace angiopose::benchmarks
