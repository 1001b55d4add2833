#include "core/geometry/pose_offset.h"
#include "core/registration/registration.h"
#include "core/vessel/tree_knots.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>

using namespace angiopose;

// Only one path of a tree is visible, marked by a wire a few mm off its axis; the initial pose is the last full pose.

namespace {

using namespace core;
using Curve3d = std::vector<Eigen::Vector3d>;

Curve3d between(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& bulge)
{
    Curve3d points;
    for (int i = 0; i <= 40; ++i) {
        const double s = i / 40.0;
        points.push_back((1.0 - s) * from + s * to + std::sin(std::numbers::pi * s) * bulge);
    }
    return points;
}

/// A trunk (1) that bifurcates into 2 and 3; 3 bifurcates into 4 and 5.
VesselTree forkedTree()
{
    const Eigen::Vector3d root(0, 0, 0);
    const Eigen::Vector3d fork(5, 0, -50);
    const Eigen::Vector3d second(35, 6, -80);
    const std::vector<Curve3d> courses{between(root, fork, {7, 3, 0}), between(fork, {-40, 4, -95}, {-8, 5, 6}),
                                       between(fork, second, {4, -6, -7}), between(second, {80, -5, -85}, {2, 8, 9}),
                                       between(second, {42, 12, -130}, {9, 0, -3})};
    VesselTree tree;
    for (const Curve3d& course : courses) {
        const int id = static_cast<int>(tree.branches.size()) + 1;
        tree.branches.push_back({id, "", course, std::vector<double>(course.size(), 2.5 - 0.3 * id)});
    }
    return tree;
}

/// A wire through the given branches, `offMm` off their axis in a slow wave.
struct WireInTree {
    explicit WireInTree(const std::vector<int>& branchIds, double offMm = 1.2, VesselTree seenTree = forkedTree())
        : tree(std::move(seenTree))
    {
        truth.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
        truth.translation = Eigen::Vector3d(3.0, -2.0, 750.0) - truth.rotation * centroidInPatient(tree);
        for (const int id : branchIds) {
            const Curve3d& course = tree.find(id)->pointsInPatient;
            axis.insert(axis.end(), course.begin(), course.end());
        }
        Curve2d curve;
        double alongMm = 0.0;
        for (std::size_t i = 0; i < axis.size(); ++i) {
            alongMm += i == 0 ? 0.0 : (axis[i] - axis[i - 1]).norm();
            const Eigen::Vector3d off(std::cos(alongMm / 20.0), 0.0, std::sin(alongMm / 25.0));
            curve.pointsPx.push_back(*project(camera, truth * (axis[i] + offMm * off)));
        }
        target.curves = {curve};
    }

    RegistrationInput from(const PoseOffset& offset) const
    {
        RegistrationInput input;
        input.tree = tree;
        input.target = target;
        input.camera = camera;
        input.initialCameraFromPatient = applyOffset(truth, offset, centroidInPatient(tree), camera);
        return input;
    }

    double errorMm(const RigidTransform& pose) const
    {
        double sum = 0.0;
        for (const Eigen::Vector3d& place : axis) {
            const Eigen::Vector2d gap = *project(camera, pose * place) - *project(camera, truth * place);
            sum += gap.norm() * millimetersPerPixel(camera, 750.0);
        }
        return sum / static_cast<double>(axis.size());
    }

    ProjectionCamera camera{-5000.0, 5000.0, 511.5, 511.5, 1024, 1024};
    VesselTree tree;
    RigidTransform truth;
    Curve3d axis;
    Centerline2d target;
};

const PoseOffset moved{.rightMm = 4.0, .upMm = -3.0, .alongRayMm = 6.0, .rollDeg = 1.5, .craCauDeg = -1.0};

RegistrationResult followed(const RegistrationInput& input, const WireOptions& wire = {}, const PoseLocks& locks = {})
{
    RegistrationOptions options;
    options.method = "wire";
    options.wire = wire;
    options.locks = locks;
    const auto result = registerVessels(input, options);
    EXPECT_TRUE(result) << (result ? "" : result.error().message.text());
    return result ? result.value() : RegistrationResult{};
}

bool isSaid(const RegistrationResult& result, std::string_view id)
{
    return std::ranges::any_of(result.warnings, [&](const Message& message) { return message.id() == id; });
}

TEST(Wire, NamesTheWayItTakesAndThePose)
{
    for (const std::vector<int>& way : {std::vector<int>{1, 3, 4}, {1, 3, 5}, {1, 2}}) {
        const WireInTree made(way);
        const RegistrationResult result = followed(made.from(moved));
        ASSERT_FALSE(result.wirePaths.empty());
        const WirePath& first = result.wirePaths.front();
        EXPECT_EQ(first.branchIds, way);
        EXPECT_GT(first.probability, 0.9);
        EXPECT_GT(first.followedShare, 0.9);
        EXPECT_LT(first.offAxisMm, 2.5);
        EXPECT_LT((first.tipInPatient - made.axis.back()).norm(), 6.0);
        EXPECT_LT((first.courseInPatient.back() - first.tipInPatient).norm(), 1e-9);
        EXPECT_EQ(first.cameraFromPatient.matrix(), result.cameraFromPatient.matrix());
        EXPECT_GT(made.errorMm(made.from(moved).initialCameraFromPatient), 4.0);
        EXPECT_LT(made.errorMm(result.cameraFromPatient), 2.5);
        EXPECT_TRUE(isSaid(result, "wire.follows"));
    }
}

TEST(Wire, ProbabilitiesAreSharesAndTheOthersAreAlternatives)
{
    const WireInTree made({1, 3});   // ends where 4 and 5 originate
    const RegistrationResult result = followed(made.from(moved));
    ASSERT_EQ(result.alternatives.size() + 1, result.wirePaths.size());
    double sum = result.wirePaths.front().probability;
    for (std::size_t i = 1; i < result.wirePaths.size(); ++i) {
        EXPECT_LE(result.wirePaths[i].probability, result.wirePaths[i - 1].probability);
        EXPECT_EQ(result.alternatives[i - 1].cameraFromPatient.matrix(),
                  result.wirePaths[i].cameraFromPatient.matrix());
        EXPECT_EQ(result.alternatives[i - 1].score, result.wirePaths[i].probability);
        sum += result.wirePaths[i].probability;
    }
    EXPECT_GT(sum, 0.5);
    EXPECT_LE(sum, 1.0 + 1e-9);
}

/// A short piece of wire in one of two parallel branches, either of which may contain it.
WireInTree doubtfulWire()
{
    VesselTree tree = forkedTree();
    VesselBranch twin = *tree.find(4);
    twin.id = 6;
    for (Eigen::Vector3d& point : twin.pointsInPatient) {
        point += Eigen::Vector3d(0.0, 0.0, -6.0);
    }
    tree.branches.push_back(std::move(twin));
    return WireInTree({4}, 0.5, std::move(tree));
}

TEST(Wire, IsNotTrustedWhereTwoWaysAreLikely)
{
    const WireInTree made = doubtfulWire();
    const RegistrationResult result = followed(made.from({.upMm = 3.0}));
    ASSERT_GE(result.wirePaths.size(), 2U);
    EXPECT_LT(result.wirePaths.front().probability, 0.9);
    EXPECT_FALSE(result.trustworthy);
    EXPECT_TRUE(isSaid(result, "wire.may-follow"));
}

TEST(Wire, AnotherWayIsTakenIfAskedFor)
{
    const WireInTree made = doubtfulWire();
    const RegistrationInput input = made.from({.upMm = 3.0});
    const RegistrationResult first = followed(input);
    ASSERT_GE(first.wirePaths.size(), 2U);
    const RegistrationResult second = followed(input, {.way = 2});
    ASSERT_EQ(second.wirePaths.size(), first.wirePaths.size());
    EXPECT_EQ(second.wirePaths[0].branchIds, first.wirePaths[1].branchIds);
    EXPECT_EQ(second.wirePaths[1].branchIds, first.wirePaths[0].branchIds);
    EXPECT_EQ(second.cameraFromPatient.matrix(), first.wirePaths[1].cameraFromPatient.matrix());
    EXPECT_FALSE(isSaid(second, "wire.fewer-ways"));

    const RegistrationResult ninth = followed(WireInTree({1, 3, 4}).from(moved), {.way = 9});
    EXPECT_TRUE(isSaid(ninth, "wire.fewer-ways"));
    EXPECT_EQ(ninth.wirePaths.front().branchIds, (std::vector<int>{1, 3, 4}));
}

TEST(Wire, StaysAsNearToTheLastPoseAsItsErrorsSay)
{
    const WireInTree made({1, 3, 4});
    const RegistrationInput input = made.from({.rightMm = 3.0, .upMm = -2.0});
    const auto movedMm = [&](const WireOptions& wire) {
        const PoseOffset offset = offsetBetween(input.initialCameraFromPatient, followed(input, wire).cameraFromPatient,
                                                centroidInPatient(made.tree), made.camera);
        return std::hypot(offset.rightMm, offset.upMm);
    };
    EXPECT_LT(movedMm({.rotationDeg = 0.1, .lateralMm = 0.1, .depthMm = 0.1}), 0.5);
    EXPECT_GT(movedMm({}), 1.5);
}

TEST(Wire, KeepsLockedAxesExactly)
{
    const WireInTree made({1, 3, 4});
    const RegistrationInput input = made.from(moved);
    PoseLocks locks{};
    for (const PoseAxis axis : {PoseAxis::AlongRay, PoseAxis::LaoRao, PoseAxis::Right}) {
        locks[static_cast<std::size_t>(axis)] = true;
    }
    RegistrationInput counted = input;
    counted.lockReference = made.truth;
    const RegistrationResult result = followed(counted, {}, locks);
    ASSERT_FALSE(result.wirePaths.empty());
    for (const WirePath& path : result.wirePaths) {
        const PoseOffset after =
            offsetBetween(made.truth, path.cameraFromPatient, centroidInPatient(made.tree), made.camera);
        EXPECT_NEAR(after.alongRayMm, moved.alongRayMm, 1e-9);
        EXPECT_NEAR(after.laoRaoDeg, moved.laoRaoDeg, 1e-9);
        EXPECT_NEAR(after.rightMm, moved.rightMm, 1e-9);
    }
    const PoseOffset off =
        offsetBetween(made.truth, result.cameraFromPatient, centroidInPatient(made.tree), made.camera);
    EXPECT_GT(std::abs(off.upMm - moved.upMm), 0.5);
    EXPECT_LT(result.uncertainty.depthMm, 0.01);
}

TEST(Wire, TurnsRoundMakeNoDifference)
{
    WireInTree made({1, 3, 5});
    const RegistrationResult one = followed(made.from(moved));
    std::ranges::reverse(made.target.curves.front().pointsPx);
    const RegistrationResult other = followed(made.from(moved));
    EXPECT_EQ(one.wirePaths.front().branchIds, other.wirePaths.front().branchIds);
    EXPECT_LT(made.errorMm(other.cameraFromPatient), 2.5);
}

TEST(Wire, InPiecesIsJoinedAndManyGapsAreNotTrusted)
{
    WireInTree made({1, 3, 4});
    const Curve2d whole = made.target.curves.front();
    const auto piece = [&](std::ptrdiff_t from, std::ptrdiff_t to) {
        Curve2d curve;
        curve.pointsPx.assign(whole.pointsPx.begin() + from, whole.pointsPx.begin() + to);
        return curve;
    };
    made.target.curves = {piece(0, 40), piece(42, 123)};
    EXPECT_EQ(followed(made.from(moved)).wirePaths.front().branchIds, (std::vector<int>{1, 3, 4}));
    made.target.curves = {piece(0, 25), piece(80, 123)};
    const RegistrationResult gappy = followed(made.from(moved));
    EXPECT_TRUE(isSaid(gappy, "wire.in-pieces"));
    EXPECT_FALSE(gappy.trustworthy);
}

TEST(Wire, FarFromTheTreeIsSaid)
{
    const WireInTree made({1, 3, 4});
    const RegistrationInput input = made.from({.rightMm = 300.0});
    const RegistrationResult result = followed(input);
    EXPECT_TRUE(result.wirePaths.empty());
    EXPECT_FALSE(result.trustworthy);
    EXPECT_TRUE(isSaid(result, "wire.nowhere"));
    EXPECT_EQ(result.cameraFromPatient.matrix(), input.initialCameraFromPatient.matrix());
}

TEST(Wire, AStopKeepsTheBestPoseUntrusted)
{
    const WireInTree made({1, 3, 4});
    RegistrationOptions options;
    options.method = "wire";
    for (const int stopAt : {1, 5, 30}) {
        IterationReport last;
        const auto result = registerVessels(made.from(moved), options, [&](const IterationReport& report) {
            EXPECT_GE(report.progress, last.progress);
            last = report;
            return report.iteration == stopAt ? ObserverDecision::Stop : ObserverDecision::Continue;
        });
        ASSERT_TRUE(result);
        EXPECT_EQ(last.iteration, stopAt);
        EXPECT_EQ(result.value().stopReason, StopReason::StoppedByUser);
        EXPECT_FALSE(result.value().trustworthy);
    }
}

TEST(Wire, RepeatsBitForBit)
{
    const WireInTree made({1, 2});
    EXPECT_EQ(followed(made.from(moved)).cameraFromPatient.matrix(),
              followed(made.from(moved)).cameraFromPatient.matrix());
}

/// A trunk (1) leading to a ring of two arcs (2, 3), with a branch (4) from its far side.
VesselTree ringTree()
{
    const Eigen::Vector3d near(0, 0, -40);
    const Eigen::Vector3d far(10, 0, -85);
    const std::vector<Curve3d> courses{between({0, 0, 0}, near, {6, 2, 0}), between(near, far, {-16, 3, 0}),
                                       between(near, far, {18, -3, 0}), between(far, {5, 4, -130}, {-8, 0, 0})};
    VesselTree tree;
    for (const Curve3d& course : courses) {
        const int id = static_cast<int>(tree.branches.size()) + 1;
        tree.branches.push_back({id, "", course, std::vector<double>(course.size(), 2.4 - 0.3 * id)});
    }
    return tree;
}

TEST(Wire, PassesARingOnEitherSide)
{
    EXPECT_EQ(treeKnots(ringTree(), {}, 2.0).cuts.size(), 1U);
    EXPECT_TRUE(treeKnots(forkedTree(), {}, 2.0).cuts.empty());
    // Each entry point cuts the ring at a different location, never at the entry itself.
    const WireInTree made({1, 2}, 0.8, ringTree());
    EXPECT_EQ(followed(made.from({.rightMm = 2.0})).wirePaths.front().branchIds, (std::vector<int>{1, 2}));
    const WireInTree other({1, 3}, 0.8, ringTree());
    EXPECT_EQ(followed(other.from({.rightMm = 2.0})).wirePaths.front().branchIds, (std::vector<int>{1, 3}));
}

}   // namespace
