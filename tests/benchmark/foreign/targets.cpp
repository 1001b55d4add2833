#include "tests/benchmark/foreign/targets.h"

#include "tests/benchmark/foreign/detector.h"
#include "tests/benchmark/foreign/filling.h"
#include "tests/benchmark/foreign/traced_widths.h"
#include "tests/benchmark/foreign/tracer.h"
#include "tests/benchmark/foreign/wide_vessel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::benchmarks {
namespace {

constexpr double rad = std::numbers::pi / 180.0;

core::RigidTransform viewTurnedBy(double leftMost, double rightMost, const RootedTree& tree, ForeignRandom& random)
{
    // Frontal view with the patient's head up, then rotated like a C-arm.
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

/// A random lateral view from either side, within 15°.
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

/// Rotation of the gantry about the isocenter by `degrees` to the side.
core::RigidTransform turnedGantry(double degrees)
{
    const Eigen::Vector3d isocenter(0.0, 0.0, sourceToPatientMm);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(degrees * rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
    return {turn, isocenter - turn * isocenter};
}

/// Perturbs a pose like the rounding of a header and a sagging gantry.
core::RigidTransform misjudged(const core::RigidTransform& pose, const Eigen::Vector3d& centroid, ForeignRandom& random)
{
    const Eigen::Vector3d turn(random.normal(), random.normal(), random.normal());
    const Eigen::Vector3d shift(random.normal(), random.normal(), random.normal());
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(0.25 * rad * turn.norm(), turn.normalized()).toRotationMatrix() * pose.rotation;
    return {rotation, pose * centroid + 0.75 * shift - rotation * centroid};
}

/// Makes an image of a whole carotid, half of the branches that leave it, and foreign vessels next to it that the tree
/// does not have.
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
    result.input.camera = detectorCamera();
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
    result.input.camera = detectorCamera();
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
    const core::RigidTransform reported = misjudged(secondFromFirst, first * centroid, random);
    std::array<ForeignCase, 2> pair;
    for (std::size_t k = 0; k < 2; ++k) {
        const core::RigidTransform view = k == 0 ? first : secondFromFirst * first;
        pair[k].truth = view;
        pair[k].filled = allOf(shown);
        pair[k].input.tree = shown.tree;
        pair[k].input.camera = detectorCamera();
        pair[k].input.target = handedOver(seen(shown, pair[k].filled, view, random), ForeignScene::WholeTree, random);
        pair[k].input.initialCameraFromPatient = k == 0 ? start : reported * start;
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
