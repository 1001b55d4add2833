#include "tests/benchmark/mixed_cases.h"

#include "core/geometry/c_arm.h"
#include "core/geometry/camera_uncertainty.h"
#include "tests/benchmark/grown_trees.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::benchmarks {
namespace {

constexpr double rad = std::numbers::pi / 180.0;
constexpr std::uint64_t casesPerTree = 4;
constexpr std::size_t minCurvePoints = 4;

using Pixels = std::vector<Eigen::Vector2d>;

/// Imaging parameters, drawn once per case.
struct Imaging {
    core::ProjectionCamera camera;
    core::RigidTransform view;   ///< cameraFromPatient
    double jitterPx = 0.5;
    double jitterReachPx = 10.0;
    bool isRounded = false;
    double lostShare = 0.0;   ///< share of pieces that the tracing missed
    std::size_t foreignCurves = 0;
    double doubledShare = 0.0;   ///< share of branches with a vein next to them
    bool hasCatheter = false;
};

core::ProjectionCamera drawnCamera(ForeignRandom& random)
{
    const int size = 512 + 64 * static_cast<int>(random.index(9));
    const double pixelMm = random.uniform(150.0, 320.0) / size;
    const double focalPx = random.uniform(900.0, 1250.0) / pixelMm;
    const double middle = 0.5 * (size - 1);
    return {-focalPx, focalPx, middle, middle, size, size};
}

core::RigidTransform drawnView(const core::VesselTree& tree, ForeignRandom& random)
{
    Eigen::Matrix3d front;
    front << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(random.uniform(-35.0, 35.0) * rad, Eigen::Vector3d::UnitX()) *
                                  Eigen::AngleAxisd(random.uniform(-60.0, 60.0) * rad, Eigen::Vector3d::UnitY()))
                                     .toRotationMatrix() *
                                 front;
    const Eigen::Vector3d place(random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0), random.uniform(640.0, 820.0));
    return {turn, place - turn * core::centroidInPatient(tree)};
}

Imaging drawnImaging(const core::VesselTree& tree, ForeignRandom& random)
{
    Imaging imaging;
    imaging.camera = drawnCamera(random);
    imaging.view = drawnView(tree, random);
    imaging.jitterPx = random.uniform(0.2, 1.2);
    imaging.jitterReachPx = random.uniform(3.0, 25.0);
    imaging.isRounded = random.uniform() < 0.5;
    imaging.lostShare = random.uniform() < 0.5 ? 0.0 : random.uniform(0.0, 0.35);
    imaging.foreignCurves = random.uniform() < 0.3 ? 0 : random.index(14);
    imaging.doubledShare = random.uniform() < 0.8 ? 0.0 : random.uniform(0.1, 0.5);
    imaging.hasCatheter = random.uniform() < 0.15;
    return imaging;
}

std::vector<std::size_t> withoutLeaves(const RootedTree& tree, double share, ForeignRandom& random)
{
    std::vector<std::size_t> kept;
    for (std::size_t branch = 0; branch < tree.parent.size(); ++branch) {
        if (!tree.isLeaf(branch) || random.uniform() >= share) {
            kept.push_back(branch);
        }
    }
    return kept;
}

/// Branches shown by an early frame: those at most `forks` bifurcations from the inflow.
std::vector<std::size_t> nearTheRoots(const RootedTree& tree, int forks)
{
    std::vector<std::size_t> kept;
    for (std::size_t branch = 0; branch < tree.parent.size(); ++branch) {
        int depth = 0;
        for (int at = tree.parent[branch]; at >= 0; at = tree.parent[static_cast<std::size_t>(at)]) {
            ++depth;
        }
        if (depth <= forks) {
            kept.push_back(branch);
        }
    }
    return kept;
}

std::vector<std::size_t> pathTo(const RootedTree& tree, std::size_t branch)
{
    std::vector<std::size_t> path;
    for (int at = static_cast<int>(branch); at >= 0; at = tree.parent[static_cast<std::size_t>(at)]) {
        path.insert(path.begin(), static_cast<std::size_t>(at));
    }
    return path;
}

std::vector<std::size_t> both(std::vector<std::size_t> one, const std::vector<std::size_t>& other)
{
    one.insert(one.end(), other.begin(), other.end());
    std::sort(one.begin(), one.end());
    one.erase(std::unique(one.begin(), one.end()), one.end());
    return one;
}

std::vector<std::size_t> drawnFilling(const RootedTree& tree, std::string& kind, ForeignRandom& random)
{
    const double draw = random.uniform();
    const auto any = [&] { return random.index(tree.parent.size()); };
    if (draw < 0.4) {
        kind = "whole";
        return withoutLeaves(tree, 0.0, random);
    }
    if (draw < 0.65) {
        kind = "leaves missing";
        return withoutLeaves(tree, random.uniform(0.1, 0.6), random);
    }
    if (draw < 0.8) {
        kind = "one territory";
        return tree.fedThrough(any());
    }
    if (draw < 0.88) {
        kind = "two territories";
        return both(tree.fedThrough(any()), tree.fedThrough(any()));
    }
    if (draw < 0.95) {
        kind = "early frame";
        return nearTheRoots(tree, 1 + static_cast<int>(random.index(2)));
    }
    kind = "one vessel";
    return pathTo(tree, any());
}

/// Adds the curve as traced, in pieces, some of which are lost.
void addTraced(const Pixels& curve, const Imaging& imaging, ForeignRandom& random, core::Centerline2d& target)
{
    const core::Centerline2d even = core::resampled({{{0, curve, {}}}}, random.uniform(0.6, 1.6));
    const double kept = std::exp(-1.0 / imaging.jitterReachPx);
    Eigen::Vector2d jitter(random.normal(), random.normal());
    Pixels piece;
    bool isMismatch = random.uniform() < imaging.lostShare;
    auto left = static_cast<int>(random.uniform(15.0, 150.0));
    const auto end = [&] {
        if (!isMismatch && piece.size() >= minCurvePoints) {
            target.curves.push_back({static_cast<int>(target.curves.size()), std::move(piece), {}});
        }
        piece.clear();
        isMismatch = random.uniform() < imaging.lostShare;
        left = static_cast<int>(random.uniform(15.0, 150.0));
    };
    for (const Eigen::Vector2d& point : even.curves.front().pointsPx) {
        jitter = kept * jitter + std::sqrt(1.0 - kept * kept) * Eigen::Vector2d(random.normal(), random.normal());
        Eigen::Vector2d at = point + imaging.jitterPx * jitter;
        if (imaging.isRounded) {
            at = at.array().round();
        }
        const bool isInside = at.minCoeff() >= 0.0 && at.x() < imaging.camera.width && at.y() < imaging.camera.height;
        if (isInside && (piece.empty() || piece.back() != at)) {
            piece.push_back(at);
        }
        if (!isInside || --left <= 0) {
            end();
        }
    }
    end();
}

Pixels foreignCurve(const core::ProjectionCamera& camera, ForeignRandom& random)
{
    Eigen::Vector2d at(random.uniform(0.05, 0.95) * camera.width, random.uniform(0.05, 0.95) * camera.height);
    double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
    double deformation = 0.0;
    Pixels curve;
    for (int left = 20 + static_cast<int>(random.index(90)); left > 0; --left) {
        curve.push_back(at);
        deformation = 0.92 * deformation + 0.02 * random.normal();
        heading += deformation;
        at += 4.0 * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    }
    return curve;
}

/// A smooth line from the lower edge to the inflow.
Pixels catheter(const core::ProjectionCamera& camera, const Eigen::Vector2d& to, ForeignRandom& random)
{
    const Eigen::Vector2d from(random.uniform(0.2, 0.8) * camera.width, camera.height - 1.0);
    const Eigen::Vector2d way = to - from;
    const Eigen::Vector2d side = random.uniform(-0.25, 0.25) * Eigen::Vector2d(-way.y(), way.x());
    Pixels curve;
    for (int k = 0; k <= 60; ++k) {
        const double t = k / 60.0;
        curve.push_back(from + t * way + std::sin(std::numbers::pi * t) * side);
    }
    return curve;
}

core::Centerline2d drawnTarget(const core::VesselTree& shown, const std::vector<std::size_t>& filled,
                               const Imaging& imaging, ForeignRandom& random)
{
    core::Centerline2d target;
    for (const std::size_t branch : filled) {
        Pixels curve;
        for (const Eigen::Vector3d& point : shown.branches[branch].pointsInPatient) {
            if (const auto pixel = core::project(imaging.camera, imaging.view * point)) {
                curve.push_back(*pixel);
            }
        }
        addTraced(curve, imaging, random, target);
        if (random.uniform() < imaging.doubledShare) {
            const Eigen::Vector2d aside(random.uniform(-30.0, 30.0), random.uniform(-30.0, 30.0));
            std::ranges::transform(curve, curve.begin(), [&](const Eigen::Vector2d& at) { return at + aside; });
            addTraced(curve, imaging, random, target);
        }
    }
    for (std::size_t k = 0; k < imaging.foreignCurves; ++k) {
        addTraced(foreignCurve(imaging.camera, random), imaging, random, target);
    }
    const auto root = core::project(imaging.camera, imaging.view * shown.branches.front().pointsInPatient.front());
    if (imaging.hasCatheter && root) {
        addTraced(catheter(imaging.camera, *root, random), imaging, random, target);
    }
    return target;
}

void spoilCamera(core::ProjectionCamera& camera, ForeignRandom& random)
{
    const double draw = random.uniform();
    if (draw < 0.15) {
        const double factor = 1.0 + random.uniform(-0.06, 0.06);
        camera.fx *= factor;
        camera.fy *= factor;
    }
    if (draw > 0.1 && draw < 0.25) {
        const double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
        camera.cx += random.uniform(5.0, 30.0) * std::cos(heading);
        camera.cy += random.uniform(5.0, 30.0) * std::sin(heading);
    }
}

/// Mirrors the image. Rotating it would not do: a rotated pose would explain it.
void mirror(RequestedCase& asked, ForeignRandom& random)
{
    const Eigen::Vector2d last(asked.trueCamera.width - 1.0, asked.trueCamera.height - 1.0);
    const Eigen::Index axis = random.uniform() < 0.5 ? 0 : 1;
    for (core::Curve2d& curve : asked.input.target.curves) {
        for (Eigen::Vector2d& at : curve.pointsPx) {
            at[axis] = last[axis] - at[axis];
        }
    }
}

core::RigidTransform displaced(const core::RigidTransform& truth, const Eigen::Vector3d& centroid,
                               ForeignRandom& random)
{
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(random.uniform(0.0, 20.0) * rad, random.direction()) * truth.rotation;
    const double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double acrossMm = random.uniform(0.0, 40.0);
    const Eigen::Vector3d shift(acrossMm * std::cos(heading), acrossMm * std::sin(heading),
                                random.uniform(-60.0, 60.0));
    return {rotation, truth * centroid + shift - rotation * centroid};
}

core::CameraUncertainty headersSpread(const core::ProjectionCamera& camera)
{
    core::CArm cArm;
    cArm.sourceToDetectorMm.origin = core::Origin::Header;
    cArm.columnSpacingMm.origin = core::Origin::Header;
    return core::uncertaintyByOrigin(cArm, camera);
}

}   // namespace

RequestedCase mixedCase(std::uint64_t number)
{
    const RootedTree tree = grownTree(number / casesPerTree);
    ForeignRandom random(500'009 + 31 * number);
    const bool isOther = random.uniform() < 0.08;
    const bool isMirrored = !isOther && random.uniform() < 0.05;
    const RootedTree shown = isOther ? grownTree(number / casesPerTree + 1000) : tree;
    const core::VesselTree moved = movedTree(shown, random);
    RequestedCase asked;
    asked.tree = tree.name;
    const std::vector<std::size_t> filled = drawnFilling(shown, asked.kind, random);
    const Imaging imaging = drawnImaging(shown.tree, random);
    const Eigen::Vector3d centroid = core::centroidInPatient(tree.tree);
    core::RigidTransform truth = imaging.view;
    truth.translation = imaging.view * core::centroidInPatient(shown.tree) - imaging.view.rotation * centroid;
    asked.trueCamera = imaging.camera;
    asked.input.tree = tree.tree;
    asked.input.camera = imaging.camera;
    asked.input.target = drawnTarget(moved, filled, imaging, random);
    asked.input.initialCameraFromPatient = displaced(truth, centroid, random);
    asked.input.cameraUncertainty = random.uniform() < 0.8 ? headersSpread(imaging.camera) : core::CameraUncertainty{};
    spoilCamera(asked.input.camera, random);
    asked.isImpossible = isOther || isMirrored;
    if (isMirrored) {
        mirror(asked, random);
    }
    asked.kind = isOther ? "another tree" : isMirrored ? "mirrored" : asked.kind;
    if (!asked.isImpossible) {
        asked.trueInCamera.resize(tree.tree.branches.size());
        for (const std::size_t branch : filled) {
            for (const Eigen::Vector3d& point : moved.branches[branch].pointsInPatient) {
                asked.trueInCamera[branch].push_back(imaging.view * point);
            }
        }
    }
    return asked;
}

}   // namespace angiopose::benchmarks
