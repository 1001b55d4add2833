#include "core/viewing/angle_map.h"

#include "core/simulation/grow_tree.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

/// A view at the given gantry angles, with the tree's centroid at the isocenter.
View viewAt(const VesselTree& tree, double primaryDeg, double secondaryDeg)
{
    View view;
    view.geometry.cArm.sourceToIsocenterMm = {750.0, Origin::User, ""};
    view.geometry.cArm.primaryAngleDeg = {primaryDeg, Origin::User, ""};
    view.geometry.cArm.secondaryAngleDeg = {secondaryDeg, Origin::User, ""};
    view.cameraFromPatient = cameraFromPatient(view.geometry.cArm, centroidInPatient(tree)).value();
    return view;
}

VesselTree straightTree(const Eigen::Vector3d& along)
{
    return {{{1, "", {-20.0 * along, 20.0 * along}, {2.0, 2.0}, -1}}};
}

ViewEvaluator sightOfBranch(const VesselTree& tree, int branchId)
{
    const auto all = vesselSegmentsOf(tree);
    return {branchSegments(all, branchId), all};
}

AngleMap mapOf(const VesselTree& tree, int branchId, const View& view, const AngleMapOptions& options = {})
{
    return computeAngleMap(sightOfBranch(tree, branchId), poseForGantryAngles(view).value(), options).value();
}

TEST(AngleMap, LooksFromTheSideAtAVesselThatRunsForwards)
{
    const VesselTree tree = straightTree(Eigen::Vector3d::UnitY());
    const AngleMap map = mapOf(tree, 1, viewAt(tree, 20.0, 10.0));
    ASSERT_FALSE(map.best.empty());
    EXPECT_NEAR(std::abs(map.best.front().angles.primaryDeg), 90.0, 1.0);
    EXPECT_LT(map.best.front().quality.cost(), 0.001);
}

TEST(AngleMap, LooksCranialAtAVesselThatTiltsBackwards)
{
    // A vessel directed upward and 30° backward: only a detector above it at CAU or CRA 30° shows its full length.
    const VesselTree tree = straightTree({0.0, std::sin(0.5236), std::cos(0.5236)});
    const AngleMap map = mapOf(tree, 1, viewAt(tree, 0.0, 0.0), {{-10.0, 10.0}, {-40.0, 40.0}, 2.5, 1});
    EXPECT_NEAR(map.best.front().angles.secondaryDeg, 30.0, 1.0);
    EXPECT_NEAR(map.at(4, map.secondaryDeg.size() / 2).foreshortening, 1.0 - std::cos(0.5236), 0.01);
}

TEST(AngleMap, FollowsThePoseAndNotWhereTheVesselsWereDrawn)
{
    // The patient is rotated by 25° about the long axis, and the best angles rotate with the patient.
    const VesselTree tree = straightTree(Eigen::Vector3d::UnitX());
    View view = viewAt(tree, 0.0, 0.0);
    const double turn = 25.0 * std::numbers::pi / 180.0;
    const RigidTransform turned{expSo3({0.0, 0.0, turn}), Eigen::Vector3d::Zero()};
    view.cameraFromPatient = view.cameraFromPatient * turned;
    const AngleMap map = mapOf(tree, 1, view, {{-60.0, 60.0}, {-5.0, 5.0}, 2.5, 1});
    EXPECT_NEAR(map.best.front().angles.primaryDeg, 25.0, 1.0);
}

TEST(AngleMap, FindsWhatBruteForceFinds)
{
    for (const std::uint64_t seed : {1, 2, 3}) {
        const VesselTree tree = growTree(seed, {}).tree;
        const View view = viewAt(tree, 0.0, 0.0);
        const PoseAtAngles poseAt = poseForGantryAngles(view).value();
        const ViewEvaluator evaluator = sightOfBranch(tree, tree.branches[3].id);
        const AngleMap map = mapOf(tree, tree.branches[3].id, view);
        double least = std::numeric_limits<double>::infinity();
        GantryAngles brute;
        for (double primary = -90.0; primary <= 90.0; primary += 1.0) {
            for (double secondary = -40.0; secondary <= 40.0; secondary += 1.0) {
                const double cost = evaluator.from(poseAt({primary, secondary})).cost();
                brute = cost < least ? GantryAngles{primary, secondary} : brute;
                least = std::min(least, cost);
            }
        }
        const AngleSuggestion& best = map.best.front();
        EXPECT_LE(best.quality.cost(), least + 1e-9) << seed;
        const bool isThere =
            std::hypot(best.angles.primaryDeg - brute.primaryDeg, best.angles.secondaryDeg - brute.secondaryDeg) <= 1.5;
        EXPECT_TRUE(isThere || best.quality.cost() < least - 1e-4) << seed;
    }
}

TEST(AngleMap, IsTheSameForAnyNumberOfThreads)
{
    const VesselTree tree = growTree(1, {}).tree;
    const View view = viewAt(tree, 0.0, 0.0);
    const AngleMap one = mapOf(tree, tree.branches[1].id, view, {{-30, 30}, {-20, 20}, 5.0, 1});
    const AngleMap two = mapOf(tree, tree.branches[1].id, view, {{-30, 30}, {-20, 20}, 5.0, 2});
    ASSERT_EQ(one.qualities.size(), two.qualities.size());
    for (std::size_t i = 0; i < one.qualities.size(); ++i) {
        EXPECT_EQ(one.qualities[i].cost(), two.qualities[i].cost());
    }
}

TEST(AngleMap, StopsAndRefuses)
{
    const VesselTree tree = straightTree(Eigen::Vector3d::UnitY());
    const View view = viewAt(tree, 0.0, 0.0);
    const PoseAtAngles poseAt = poseForGantryAngles(view).value();
    const ViewEvaluator evaluator = sightOfBranch(tree, 1);
    EXPECT_TRUE(
        computeAngleMap(evaluator, poseAt, {}, [](double) { return ObserverDecision::Stop; }).error().isCancellation());
    EXPECT_EQ(computeAngleMap(evaluator, poseAt, {{10, -10}, {-40, 40}, 2.5, 1}).error().message.id(),
              "angles.range-odd");
    EXPECT_EQ(computeAngleMap(evaluator, poseAt, {{-90, 90}, {-95, 40}, 2.5, 1}).error().message.id(),
              "angles.range-odd");
    EXPECT_EQ(computeAngleMap(evaluator, poseAt, {{-90, NAN}, {-40, 40}, 2.5, 1}).error().message.id(),
              "angles.range-odd");
    EXPECT_EQ(computeAngleMap(evaluator, poseAt, {{-90, 90}, {-40, 40}, 0.1, 1}).error().message.id(),
              "angles.step-too-fine");
}

TEST(TurnedGantry, StandsWhereItStoodAndNeedsAngles)
{
    const VesselTree tree = growTree(1, {}).tree;
    View view = viewAt(tree, 20.0, -10.0);
    const GantryAngles now = gantryAnglesOf(view).value();
    EXPECT_TRUE(poseForGantryAngles(view).value()(now).rotation.isApprox(view.cameraFromPatient.rotation, 1e-12));
    EXPECT_TRUE(poseForGantryAngles(view).value()(now).translation.isApprox(view.cameraFromPatient.translation, 1e-9));
    const RigidTransform elsewhere = poseForGantryAngles(view).value()({-30.0, 5.0});
    EXPECT_TRUE(elsewhere.rotation.isApprox(viewAt(tree, -30.0, 5.0).cameraFromPatient.rotation, 1e-12));
    EXPECT_TRUE(elsewhere.translation.isApprox(viewAt(tree, -30.0, 5.0).cameraFromPatient.translation, 1e-9));
    view.geometry.cArm.primaryAngleDeg = {};
    EXPECT_FALSE(gantryAnglesOf(view));
    EXPECT_EQ(poseForGantryAngles(view).error().message.id(), "geometry.angles-missing");
}

}   // namespace
}   // namespace angiopose::core
