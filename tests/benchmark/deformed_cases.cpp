#include "tests/benchmark/deformed_cases.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace angiopose::benchmarks {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double sourceToTreeMm = 760.0;
constexpr double jitterPx = 0.5;
constexpr double jitterLengthPx = 4.0;
constexpr double missingShare = 0.2;
constexpr double foreignShare = 0.2;

/// Transform from patient LPS to a camera that looks from behind: x to the left of the patient, y to the feet.
core::RigidTransform viewOf(double primaryDeg, double secondaryDeg, core::CounterRandom& random)
{
    Eigen::Matrix3d cameraFromPatient;
    cameraFromPatient << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    core::RigidTransform view;
    view.rotation = core::expSo3(Eigen::Vector3d::UnitX() * secondaryDeg * degree) *
                    core::expSo3(Eigen::Vector3d::UnitY() * primaryDeg * degree) * cameraFromPatient;
    view.translation = {random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0), sourceToTreeMm};
    return view;
}

std::vector<Eigen::Vector2d> jittered(const std::vector<Eigen::Vector2d>& points, core::CounterRandom& random)
{
    const double keep = std::exp(-1.0 / jitterLengthPx);
    Eigen::Vector2d offset = jitterPx * Eigen::Vector2d(random.normal(), random.normal());
    std::vector<Eigen::Vector2d> pixels;
    for (const Eigen::Vector2d& point : points) {
        offset =
            keep * offset + jitterPx * std::sqrt(1.0 - keep * keep) * Eigen::Vector2d(random.normal(), random.normal());
        const Eigen::Vector2d pixel = (point + offset).array().round();
        if (pixels.empty() || pixels.back() != pixel) {
            pixels.push_back(pixel);
        }
    }
    return pixels;
}

/// Cuts a curve at positions unrelated to the tree, as crossings do.
void addPieces(const std::vector<Eigen::Vector2d>& pixels, core::CounterRandom& random,
               std::vector<std::vector<Eigen::Vector2d>>& pieces)
{
    for (std::size_t first = 0; first + 3 < pixels.size();) {
        const auto length = static_cast<std::size_t>(random.uniform(20.0, 120.0));
        const std::size_t end = pixels.size() < first + length + 8 ? pixels.size() : first + length;
        pieces.emplace_back(pixels.begin() + static_cast<std::ptrdiff_t>(first),
                            pixels.begin() + static_cast<std::ptrdiff_t>(end));
        if (random.uniform() < 0.5) {
            std::ranges::reverse(pieces.back());
        }
        first = end;
    }
}

std::vector<Eigen::Vector2d> foreignCurve(const core::ProjectionCamera& camera, core::CounterRandom& random)
{
    Eigen::Vector2d at(random.uniform(0.15, 0.85) * camera.width, random.uniform(0.15, 0.85) * camera.height);
    double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
    double deformation = 0.0;
    std::vector<Eigen::Vector2d> points;
    const int count = 80 + random.index(200);
    for (int k = 0; k < count; ++k) {
        points.push_back(at);
        deformation = 0.97 * deformation + 0.006 * random.normal();
        heading += deformation;
        at += Eigen::Vector2d(std::cos(heading), std::sin(heading));
    }
    return points;
}

std::vector<Eigen::Vector2d> projected(const core::VesselBranch& branch, const DeformedView& view)
{
    core::Curve2d curve;
    for (const Eigen::Vector3d& point : branch.pointsInPatient) {
        if (const auto pixel = core::project(view.camera, view.truth * point)) {
            curve.pointsPx.push_back(*pixel);
        }
    }
    const core::Centerline2d even = core::resampled({{curve}}, 0.7);
    std::vector<Eigen::Vector2d> inside;
    for (const Eigen::Vector2d& pixel : even.curves.front().pointsPx) {
        if (pixel.minCoeff() >= 0.0 && pixel.x() < view.camera.width && pixel.y() < view.camera.height) {
            inside.push_back(pixel);
        }
    }
    return inside;
}

core::Centerline2d targetOf(const core::VesselTree& deformed, const std::vector<bool>& isMissing,
                            const DeformedView& view, core::CounterRandom& random)
{
    std::vector<std::vector<Eigen::Vector2d>> pieces;
    for (std::size_t b = 0; b < deformed.branches.size(); ++b) {
        if (!isMissing[b]) {
            addPieces(jittered(projected(deformed.branches[b], view), random), random, pieces);
        }
    }
    const auto foreign = static_cast<int>(foreignShare * static_cast<double>(deformed.branches.size()));
    for (int k = 0; k < foreign; ++k) {
        addPieces(jittered(foreignCurve(view.camera, random), random), random, pieces);
    }
    for (std::size_t k = pieces.size(); k-- > 1;) {
        std::swap(pieces[k], pieces[static_cast<std::size_t>(random.index(static_cast<int>(k) + 1))]);
    }
    core::Centerline2d target;
    for (std::vector<Eigen::Vector2d>& piece : pieces) {
        target.curves.push_back({static_cast<int>(target.curves.size()), std::move(piece), {}});
    }
    return target;
}

/// Chooses unopacified branches among those with a free end.
std::vector<bool> missingBranches(const core::VesselTree& tree, core::CounterRandom& random)
{
    std::vector<bool> isMissing(tree.branches.size(), false);
    for (const core::VesselNode& node : core::findNodes(tree)) {
        if (!node.isBifurcation() && random.uniform() < missingShare) {
            for (std::size_t b = 0; b < tree.branches.size(); ++b) {
                isMissing[b] = isMissing[b] || tree.branches[b].id == node.branchIds.front();
            }
        }
    }
    return isMissing;
}

}   // namespace

core::VesselTree centered(core::VesselTree tree)
{
    const Eigen::Vector3d middle = core::centroidInPatient(tree);
    for (core::VesselBranch& branch : tree.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            point -= middle;
        }
    }
    return tree;
}

DeformedCase makeDeformedCase(const core::VesselTree& tree, const TrueMotion& motion,
                              const std::vector<double>& turnsDeg, core::CounterRandom random)
{
    DeformedCase made;
    made.tree = tree;
    made.deformed = deformedBy(tree, motion, random.fork(1));
    made.isMissing = missingBranches(tree, random);
    const double primaryDeg = random.uniform(-30.0, 30.0);
    const double secondaryDeg = random.uniform(-20.0, 20.0);
    core::Vector6d error;
    for (Eigen::Index k = 0; k < 6; ++k) {
        error[k] = random.normal() * (k < 3 ? degree : 3.0);
    }
    const Eigen::Vector3d centroid = core::centroidInPatient(tree);
    core::RigidTransform patientError;   // about the centroid, the same for all views
    patientError.rotation = core::expSo3(error.head<3>());
    patientError.translation = centroid - patientError.rotation * centroid + error.tail<3>();
    for (const double turnDeg : turnsDeg) {
        DeformedView view;
        view.camera = {-3800.0, 3800.0, 511.5, 511.5, 1024, 1024};
        view.truth = viewOf(primaryDeg + turnDeg, secondaryDeg, random);
        view.nominal = view.truth * patientError;
        view.target = targetOf(made.deformed, made.isMissing, view, random);
        made.views.push_back(std::move(view));
    }
    return made;
}

std::vector<DeformedFrame> makeDeformedRun(const DeformedCase& first, const TrueMotion& motion, double breathMm,
                                           double framesPerBreath, std::size_t frames, core::CounterRandom random)
{
    const core::VesselTree other = deformedBy(first.tree, motion, random.fork(2));
    std::vector<DeformedFrame> run;
    for (std::size_t t = 0; t < frames; ++t) {
        const double phase = 2.0 * std::numbers::pi * static_cast<double>(t) / framesPerBreath;
        DeformedFrame frame{first.tree, first.views.front()};
        for (std::size_t b = 0; b < frame.deformed.branches.size(); ++b) {
            for (std::size_t i = 0; i < frame.deformed.branches[b].pointsInPatient.size(); ++i) {
                const Eigen::Vector3d& still = first.tree.branches[b].pointsInPatient[i];
                frame.deformed.branches[b].pointsInPatient[i] +=
                    std::cos(phase) * (first.deformed.branches[b].pointsInPatient[i] - still) +
                    0.5 * std::sin(phase) * (other.branches[b].pointsInPatient[i] - still);
            }
        }
        frame.view.truth.translation.y() += 0.5 * breathMm * (1.0 - std::cos(phase));
        frame.view.target = targetOf(frame.deformed, first.isMissing, frame.view, random);
        run.push_back(std::move(frame));
    }
    return run;
}

}   // namespace angiopose::benchmarks
