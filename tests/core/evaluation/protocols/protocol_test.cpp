#include "core/evaluation/protocols/protocol.h"

#include "core/evaluation/trial/evaluated_method.h"
#include "core/evaluation/trial/projection_error.h"
#include "core/simulation/prune_tree.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <set>

using namespace angiopose;

namespace {

using namespace core;

Trial makeTrial(std::string_view protocol, const std::string& condition, std::uint64_t trial, std::uint64_t seed = 1)
{
    const Protocol& row = *findProtocol(protocol);
    const auto chosen = parseConditions(row, condition);
    return row.prepare(chosen.value().front(), seed)(trial);
}

PosePair startOf(const Trial& trial)
{
    return {trial.input.initialCameraFromPatient, trial.trueCameraFromPatient};
}

TEST(Protocols, HaveDistinctIdsAndConditions)
{
    std::set<std::string_view> ids;
    for (const Protocol& protocol : protocols()) {
        EXPECT_TRUE(ids.insert(protocol.id).second);
        EXPECT_GT(protocol.defaultTrials, 0u);
        std::set<std::string> conditions;
        for (const Condition& condition : protocol.conditions) {
            EXPECT_TRUE(conditions.insert(condition.id).second) << condition.id;
            EXPECT_EQ(condition.id.find(','), std::string::npos);
        }
        EXPECT_FALSE(parseConditions(protocol, "").value().empty());
        EXPECT_EQ(parseConditions(protocol, "all").value().size(), protocol.conditions.size());
        EXPECT_FALSE(parseConditions(protocol, "magic"));
    }
    EXPECT_EQ(findProtocol("magic"), nullptr);
}

TEST(Protocols, ConditionsAreFoundByTheirBeginning)
{
    const Protocol& robustness = *findProtocol("robustness");
    EXPECT_EQ(parseConditions(robustness, "full").value().size(), 3u);
    EXPECT_EQ(parseConditions(robustness, "full-5-2").value().size(), 1u);
    EXPECT_EQ(parseConditions(robustness, "full-5-2,pruned").value().size(), 4u);
    EXPECT_FALSE(parseConditions(robustness, "ful"));   // prefixes must end at a dash
}

TEST(Protocols, TrialsDependOnSeedAndNumberAlone)
{
    for (const std::string_view protocol : {"toy", "simulation", "robustness", "capture-range"}) {
        const Protocol& row = *findProtocol(protocol);
        const std::string condition = row.conditions.back().id;
        const Trial once = makeTrial(protocol, condition, 7);
        const Trial again = makeTrial(protocol, condition, 7);
        EXPECT_EQ(once.input.initialCameraFromPatient.matrix(), again.input.initialCameraFromPatient.matrix());
        EXPECT_EQ(once.input.target.pointCount(), again.input.target.pointCount());
        EXPECT_NE(makeTrial(protocol, condition, 8).input.initialCameraFromPatient.matrix(),
                  once.input.initialCameraFromPatient.matrix());
        EXPECT_NE(makeTrial(protocol, condition, 7, 2).input.initialCameraFromPatient.matrix(),
                  once.input.initialCameraFromPatient.matrix());
    }
}

TEST(ToyProtocol, ShowsATiltedSquareShiftedByOne)
{
    for (const auto& [condition, points] : {std::pair<std::string, std::size_t>{"b1-8", 8}, {"b1-164", 164}}) {
        const Trial trial = makeTrial("toy", condition, 3);
        EXPECT_EQ(trial.tree->pointCount(), points + 4);   // corners belong to two edges
        const PoseError start = poseError(centroidInPatient(*trial.tree), startOf(trial));
        EXPECT_NEAR(start.centroidMm, 1.0, 1e-9);
        EXPECT_NEAR(start.angleDeg, 0.0, 1e-6);
    }
    const Trial turned = makeTrial("toy", "b2-44", 3);
    EXPECT_NEAR(poseError(centroidInPatient(*turned.tree), startOf(turned)).angleDeg, 1.0, 1e-9);
    // The near edge has a depth of 12.5 − 2.5 cos 30°, the far one 12.5 + 2.5 cos 30°.
    double width = 0.0;
    double height = 0.0;
    for (const Curve2d& a : turned.input.target.curves) {
        for (const Curve2d& b : turned.input.target.curves) {
            width = std::max(width, (a.pointsPx.front() - b.pointsPx.front()).cwiseAbs().x());
            height = std::max(height, (a.pointsPx.front() - b.pointsPx.front()).cwiseAbs().y());
        }
    }
    EXPECT_NEAR(width, 520.0 * 5.0 / 10.335, 0.1);
    EXPECT_NEAR(height, 520.0 * 1.25 * (1.0 / 10.335 + 1.0 / 14.665), 0.1);
}

TEST(ToyProtocol, ShowsTheSquareAsPrintedAsOneLine)
{
    const Trial trial = makeTrial("toy", "a-44", 3);
    EXPECT_EQ(trial.trueCameraFromPatient.matrix(), Eigen::Matrix4d::Identity());
    EXPECT_NEAR(poseError(centroidInPatient(*trial.tree), startOf(trial)).centroidMm, 1.0, 1e-9);
    double farthest = 0.0;
    for (const Curve2d& curve : trial.input.target.curves) {
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            EXPECT_NEAR(point.y(), 512.0, 1e-9);
            farthest = std::max(farthest, point.x());
        }
    }
    EXPECT_NEAR(farthest, 512.0 + 520.0 * 10.0 / 10.0, 1e-9);   // beyond the image's last column
}

TEST(SimulationProtocol, DisturbsAboutSourceOrCentroid)
{
    const Protocol& simulation = *findProtocol("simulation");
    const auto meanStartPx = [&](const std::string& condition) {
        const TrialMaker maker = simulation.prepare(parseConditions(simulation, condition).value().front(), 1);
        double sum = 0.0;
        for (std::uint64_t number = 0; number < 40; ++number) {
            const Trial trial = maker(number);
            sum += projectionError(*trial.tree, trial.input.camera, startOf(trial)).meanPx;
        }
        return sum / 40.0;
    };
    EXPECT_NEAR(meanStartPx("cam-2-5"), 77.0, 20.0);   // ALGORITHMS §4.2
    EXPECT_NEAR(meanStartPx("cam-norm-2-5"), 48.0, 8.0);
    EXPECT_NEAR(meanStartPx("obj-2-5"), 17.0, 4.0);
}

TEST(SimulationProtocol, HasExactPartnersOnlyWhereItSaysSo)
{
    for (const auto& [condition, isExact] :
         {std::pair<std::string, bool>{"exact-obj-2-5", true}, {"obj-2-5", false}, {"cam-2-5", false}}) {
        const Trial trial = makeTrial("simulation", condition, 4);
        EXPECT_EQ(trial.targetIsExact, isExact) << condition;
        EXPECT_EQ(trial.input.target.pointCount() == trial.tree->pointCount(), isExact) << condition;
    }
}

TEST(SimulationProtocol, KnowsTheBoundOfDegradedTargets)
{
    const Trial trial = makeTrial("simulation", "degraded-obj-2-5", 4);
    EXPECT_FALSE(trial.targetIsExact);
    ASSERT_TRUE(trial.errorBound);
    EXPECT_NEAR(std::sqrt((*trial.errorBound)(5, 5)), 0.95, 0.7);   // depth, ALGORITHMS §6.10
    EXPECT_FALSE(makeTrial("simulation", "obj-2-5", 4).errorBound);
}

TEST(RobustnessProtocol, StartsAtFixedDistances)
{
    for (std::uint64_t number = 0; number < 6; ++number) {
        const Trial trial = makeTrial("robustness", "full-8-3", number);
        const PoseError start = poseError(centroidInPatient(*trial.tree), startOf(trial));
        EXPECT_NEAR(start.angleDeg, 3.0, 1e-9);
        // The shift of the twist; the screw motion rotates it by half the angle.
        EXPECT_NEAR(start.seedDistanceMm, 8.0, 0.01);
        const Eigen::Vector3d shift =
            (trial.input.initialCameraFromPatient * trial.trueCameraFromPatient.inverse()).translation;
        EXPECT_LT(std::abs(shift.z()), 0.25);   // lateral
    }
}

TEST(RobustnessProtocol, PrunesLeavesOnTheSideItNames)
{
    const auto branches = [](const std::string& condition) {
        const Trial trial = makeTrial("robustness", condition, 2);
        return std::pair(trial.input.tree.branches.size(), trial.input.target.curves.size());
    };
    const auto [fullTree, fullTarget] = branches("full-5-2");
    EXPECT_EQ(branches("pruned-5-2"), std::pair(fullTree, fullTarget - 5));
    EXPECT_EQ(branches("both-5-2"), std::pair(fullTree - 5, fullTarget - 5));
}

TEST(PruneTree, TakesOnlyBranchesThatNoOtherLeaves)
{
    const Trial trial = makeTrial("robustness", "full-5-2", 1);
    const VesselTree& tree = *trial.tree;
    const std::vector<int> leaves = leafBranchIds(tree);
    EXPECT_GE(leaves.size(), tree.branches.size() / 3);
    EXPECT_LT(leaves.size(), tree.branches.size());
    CounterRandom random(1);
    EXPECT_EQ(removeRandomLeaves(tree, 1000, random).branches.size(), tree.branches.size() - leaves.size());
}

TEST(ClinicalProtocol, TracesTheSameTreeInDifferentViews)
{
    const Trial first = makeTrial("clinical", "nonrigid-1", 0);
    const Trial second = makeTrial("clinical", "nonrigid-1", 6);
    EXPECT_EQ(first.tree->pointCount(), second.tree->pointCount());
    EXPECT_EQ(first.tree->branches.back().pointsInPatient, second.tree->branches.back().pointsInPatient);
    EXPECT_NE(first.trueCameraFromPatient.matrix(), second.trueCameraFromPatient.matrix());
    EXPECT_GT(first.input.target.pointCount(), 200u);
    EXPECT_TRUE(first.traceMs);
}

TEST(TrustProtocol, MakesTheSameViewsHarderOrImpossible)
{
    const Trial given = makeTrial("trust", "as-given", 3);
    EXPECT_TRUE(given.hasCorrectPose);
    EXPECT_LT(targetError(targetsOf(*given.tree), startOf(given)).mtreInPlaneMm, 60.0);

    const Trial far = makeTrial("trust", "far-start", 3);
    EXPECT_TRUE(far.hasCorrectPose);
    EXPECT_EQ(far.input.target.pointCount(), given.input.target.pointCount());
    const PoseError start = poseError(centroidInPatient(*far.tree), startOf(far));
    EXPECT_GE(start.angleDeg, 30.0);
    EXPECT_LE(start.angleDeg, 75.0);
    EXPECT_GE(start.centroidInPlaneMm, 60.0);
    EXPECT_LE(start.centroidInPlaneMm, 150.0);

    const Trial mirrored = makeTrial("trust", "mirrored", 3);
    EXPECT_FALSE(mirrored.hasCorrectPose);
    const ImageF& image = *given.input.image;
    EXPECT_EQ(mirrored.input.image->at(10, 200), image.at(image.width - 11, 200));

    const Trial other = makeTrial("trust", "other-tree", 3);
    EXPECT_FALSE(other.hasCorrectPose);
    EXPECT_EQ(other.input.image->pixels, image.pixels);
    EXPECT_NE(other.tree->branches.front().pointsInPatient, given.tree->branches.front().pointsInPatient);
    const auto centroidInCamera = [](const Trial& trial) {
        return trial.input.initialCameraFromPatient * centroidInPatient(*trial.tree);
    };
    EXPECT_LT((centroidInCamera(other) - centroidInCamera(given)).norm(), 1e-9);
}

TEST(TrustProtocol, CutsTheImageAndItsCameraAlike)
{
    const Trial whole = makeTrial("trust", "as-given", 5);
    const Trial half = makeTrial("trust", "half-outside", 5);
    const ProjectionCamera& camera = half.input.camera;
    EXPECT_EQ(2 * camera.width * camera.height, whole.input.camera.width * whole.input.camera.height);
    const int left = static_cast<int>(std::lround(whole.input.camera.cx - camera.cx));
    const int top = static_cast<int>(std::lround(whole.input.camera.cy - camera.cy));
    EXPECT_EQ(half.input.image->at(100, 90), whole.input.image->at(100 + left, 90 + top));
}

TEST(TrustProtocol, LeavesErrorsUnknownWhereNoPoseIsRight)
{
    const Trial other = makeTrial("trust", "other-tree", 1);
    const auto run = runTrial(other, parseMethod("angiopose").value(), KeepHistory::No, [] { return false; });
    ASSERT_TRUE(run);
    EXPECT_TRUE(std::isnan(run->mrpdMm));
    EXPECT_TRUE(std::isnan(run->meanMm));
    EXPECT_EQ(run->hasResult, 1.0);
}

TEST(CaptureRangeProtocol, StartsInsideTheBin)
{
    for (const auto& [condition, from, to] :
         {std::tuple<std::string, double, double>{"clean-3-4", 3.0, 4.0}, {"clean-145-150", 145.0, 150.0}}) {
        for (std::uint64_t number = 0; number < 6; ++number) {
            const Trial trial = makeTrial("capture-range", condition, number);
            const double mtreMm = targetError(targetsOf(*trial.tree), startOf(trial)).mtreMm;
            EXPECT_GE(mtreMm, from - 1e-6);
            EXPECT_LE(mtreMm, to + 1e-6);
        }
    }
}

}   // namespace
