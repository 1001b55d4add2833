#include "core/registration/registration.h"

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/alignment_points.h"
#include "tests/support/clean_case.h"
#include "tests/support/matchers.h"

#include "core/messages/messages.h"
#include "core/simulation/grow_tree.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace angiopose::core {
namespace {

/// About 0.7 px of noise, correlated between neighbors, on the curves of 80 % of the branches.
Centerline2d traced(const Centerline2d& exact, CounterRandom& random)
{
    Centerline2d result;
    for (const Curve2d& curve : resampled(exact, 1.0).curves) {
        if (random.uniform() < 0.2) {
            continue;
        }
        Curve2d noisy{curve.id, {}, {}};
        const double keep = std::exp(-1.0 / 5.0);
        Eigen::Vector2d error = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            const double x = random.normal();
            error = keep * error + std::sqrt(1.0 - keep * keep) * 0.7 * Eigen::Vector2d(x, random.normal());
            noisy.pointsPx.emplace_back((point + error).array().round());
        }
        result.curves.push_back(std::move(noisy));
    }
    return result;
}

constexpr double idealErrorPx =
    0.05;   // for noise-free targets; line-based methods use no point partners (ALGORITHMS §7)

TEST(RegisterVessels, RecoversKnownPoseFromNearbyStart)
{
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        const test::CleanCase clean(seed);
        const auto result = registerVessels(clean.fromNearby(seed));
        ASSERT_TRUE(result);
        EXPECT_LT(meanErrorPx(clean, result.value().cameraFromPatient), idealErrorPx) << "tree " << seed;
        EXPECT_TRUE(result.value().trustworthy) << "tree " << seed;
        EXPECT_EQ(result.value().stopReason, StopReason::Converged);
    }
}

TEST(RegisterVessels, RecoversKnownPoseFromFarStart)
{
    for (const std::uint64_t seed : {1, 2, 3}) {
        const test::CleanCase clean(seed);
        const Eigen::Vector3d centroid = centroidInPatient(clean.tree);
        RigidTransform start = clean.truth;
        start.rotation = expSo3(Eigen::Vector3d(0.15, -0.12, 0.15)) * start.rotation;
        start.translation = clean.truth * centroid + Eigen::Vector3d(45.0, -40.0, 10.0) - start.rotation * centroid;
        const auto result = registerVessels(clean.from(start));
        ASSERT_TRUE(result);
        EXPECT_LT(meanErrorPx(clean, result.value().cameraFromPatient), idealErrorPx) << "tree " << seed;
    }
}

TEST(RegisterVessels, MissingBranchesAndClutterDoNotPull)
{
    for (const std::uint64_t seed : {1, 2, 3}) {
        test::CleanCase clean(seed);
        CounterRandom random(40 + seed);
        clean.target = traced(clean.target, random);
        Curve2d clutter{999, {}, {}};
        for (int i = 0; i < 500; ++i) {
            clutter.pointsPx.emplace_back(250.0 + i, 400.0 + 80.0 * std::sin(i / 60.0));
        }
        clean.target.curves.push_back(clutter);
        const auto result = registerVessels(clean.from(clean.nearbyStart(random)));
        ASSERT_TRUE(result);
        EXPECT_LT(meanErrorPx(clean, result.value().cameraFromPatient), 0.6) << "tree " << seed;
    }
}

TEST(RegisterVessels, TrustsATreeThatRunsAlongTheVesselsThoughMostLiesOutside)
{
    test::CleanCase clean(2);
    CounterRandom random(5);
    clean.target = traced(clean.target, random);
    clean.camera.width = 480;   // keeps the left part of the image
    const auto isOutside = [](const Eigen::Vector2d& point) { return point.x() > 479.0; };
    const std::size_t whole = clean.target.pointCount();
    for (Curve2d& curve : clean.target.curves) {
        std::erase_if(curve.pointsPx, isOutside);
    }
    std::erase_if(clean.target.curves, [](const Curve2d& curve) { return curve.pointsPx.size() < 2; });
    ASSERT_LT(clean.target.pointCount(), 4 * whole / 10);
    const auto result = registerVessels(clean.from(clean.nearbyStart(random)));
    ASSERT_TRUE(result);
    EXPECT_LT(meanErrorPx(clean, result.value().cameraFromPatient), 2.0);
    EXPECT_TRUE(result.value().trustworthy) << result.value().warnings.front();
}

/// The tree flattened into a plane through the source, so that its projection is one vertical line.
test::CleanCase seenEdgeOn(std::uint64_t seed)
{
    test::CleanCase clean(seed);
    const RigidTransform patientFromCamera = clean.truth.inverse();
    for (VesselBranch& branch : clean.tree.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            Eigen::Vector3d inCamera = clean.truth * point;
            inCamera.x() = 0.0;
            point = patientFromCamera * inCamera;
        }
    }
    CounterRandom random(seed);
    clean.target = traced(projectTree(clean.tree, clean.camera, clean.truth), random);
    return clean;
}

TEST(RegisterVessels, KnowsThatVesselsSeenEdgeOnMaySlideAlongTheirLine)
{
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        const test::CleanCase clean = seenEdgeOn(seed);
        RigidTransform start = clean.truth;
        start.translation += Eigen::Vector3d(2.0, 5.0, 5.0);
        const auto result = registerVessels(clean.from(start));
        ASSERT_TRUE(result);
        EXPECT_FALSE(result.value().trustworthy) << "tree " << seed;
        EXPECT_LT(result.value().probabilityWithin2Mm.value_or(0.0), 0.8) << "tree " << seed;
        EXPECT_FALSE(result.value().uncertainty.observed[4]) << "tree " << seed;
        EXPECT_GT(result.value().uncertainty.inPlaneMm, 3.0) << "tree " << seed;
        EXPECT_EQ(std::ranges::count(result.value().warnings, messages::shiftAlongVesselsUncertain()), 1)
            << "tree " << seed;
    }
}

TEST(RegisterVessels, DoesNotCallAFullTreeASinglePathBesideItsVessels)
{
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        const test::CleanCase clean(seed);
        for (const double asideMm : {3.0, 6.0, 12.0, 25.0}) {
            for (const Eigen::Vector3d way : {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()}) {
                RigidTransform nudged = clean.truth;
                nudged.translation += asideMm * way;
                const auto judged = evaluatePose(clean.from(clean.truth), nudged);
                ASSERT_TRUE(judged);
                EXPECT_FALSE(judged.value().trustworthy) << "tree " << seed << ", " << asideMm << " mm";
                EXPECT_EQ(std::ranges::count(judged.value().warnings, messages::singlePathVisible()), 0)
                    << "tree " << seed << ", " << asideMm << " mm";
                EXPECT_FALSE(judged.value().warnings.empty());
            }
        }
    }
}

TEST(RegisterVessels, TrustsASinglePathOnlyWhereItsWidthShowsLumen)
{
    test::CleanCase clean(5);
    CounterRandom random(2);
    VesselBranch& trunk = clean.tree.branches.front();
    for (std::size_t i = 0; i < trunk.radiusMm.size(); ++i) {
        trunk.radiusMm[i] = 3.0 - 2.0 * static_cast<double>(i) / static_cast<double>(trunk.radiusMm.size());
    }
    const double mmPerPx = millimetersPerPixel(clean.camera, 800.0);
    const auto registered = [&](const VesselTree& seen, const std::function<double(double)>& seenRadiusMm) {
        RegistrationInput input = clean.from(clean.nearbyStart(random));
        input.target = projectTree(seen, clean.camera, clean.truth);
        for (std::size_t b = 0; b < seen.branches.size(); ++b) {
            std::vector<double>& radiusPx = input.target.curves[b].radiusPx;
            radiusPx.clear();
            for (const double radiusMm : seen.branches[b].radiusMm) {
                radiusPx.push_back(seenRadiusMm(radiusMm) / mmPerPx);
            }
        }
        for (const VesselBranch& branch : clean.tree.branches) {
            if (!seen.find(branch.id)) {
                input.excludedBranchIds.push_back(branch.id);
            }
        }
        return registerVessels(input).value();
    };
    VesselTree alone = clean.tree;
    alone.branches = {trunk};
    for (const double deviceMm : {0.0, 1.0}) {   // unknown, or the diameter of a catheter
        const RegistrationResult path = registered(alone, [deviceMm](double) { return deviceMm; });
        EXPECT_FALSE(path.trustworthy);
        EXPECT_EQ(std::ranges::count(path.warnings, messages::singlePathVisible()), 1);
    }
    const RegistrationResult vessel = registered(alone, [](double radiusMm) { return 0.9 * radiusMm; });
    EXPECT_TRUE(vessel.indicators.isLumen);
    EXPECT_EQ(std::ranges::count(vessel.warnings, messages::singlePathVisible()), 0);
    const RegistrationResult whole = registered(clean.tree, [](double) { return 0.0; });
    EXPECT_TRUE(whole.trustworthy);
    EXPECT_EQ(std::ranges::count(whole.warnings, messages::singlePathVisible()), 0);
}

TEST(RegisterVessels, PriorDoesNotPullVisibly)
{
    test::CleanCase clean(5);
    CounterRandom random(3);
    clean.target = traced(clean.target, random);
    const RegistrationInput input = clean.from(clean.nearbyStart(random));
    const auto result = registerVessels(input);
    ASSERT_TRUE(result);

    // Distance by which the prior shifts the minimum of the image's own cost (ALGORITHMS §6.6 a).
    const RegistrationProblem problem = makeProblem(input, {}).value();
    const TargetLines target(problem.target, problem.camera);
    const CentroidPose pose = aboutCentroid(result.value().cameraFromPatient, problem.tree.centroid);
    const Matrix6d image = Alignment(alignmentPoints(problem.tree), problem.camera, target)
                               .evaluate(pose, 1.0)
                               .equations.hessian.selfadjointView<Eigen::Lower>();
    NormalEquations pull;
    initialPosePrior(aboutCentroid(problem.start, problem.tree.centroid), {}).add(pose, noiseVariance(1.0), pull);
    const Vector6d bias = image.ldlt().solve(pull.gradient);
    const Vector6d std = result.value().uncertainty.covariance.diagonal().cwiseSqrt();
    EXPECT_LT(bias.cwiseQuotient(std).cwiseAbs().maxCoeff(), 0.05);
}

TEST(RegisterVessels, UncertaintyMatchesTheErrors)
{
    double sum = 0.0;
    int count = 0;
    for (std::uint64_t trial = 0; trial < 100; ++trial) {
        test::CleanCase clean(10 + trial % 5);
        CounterRandom random = CounterRandom(77).fork(trial);
        clean.target = traced(clean.target, random);
        RegistrationOptions options;
        options.pointSpacingMm = 2.0;
        const auto result = registerVessels(clean.from(clean.nearbyStart(random)), options);
        ASSERT_TRUE(result);
        const PosePair poses{result.value().cameraFromPatient, clean.truth};
        sum += normalizedErrorSquared(errorAboutCentroid(centroidInPatient(clean.tree), poses),
                                      result.value().uncertainty.covariance);
        ++count;
    }
    EXPECT_GT(sum / count, 4.5);
    EXPECT_LT(sum / count, 8.0);
}

TEST(RegisterVessels, SameInputGivesSameBits)
{
    const test::CleanCase clean(4);
    const RegistrationInput input = clean.fromNearby(1);
    RegistrationOptions options;
    const auto once = registerVessels(input, options);
    const auto again = registerVessels(input, options);
    ASSERT_TRUE(once && again);
    EXPECT_EQ(once.value().cameraFromPatient.matrix(), again.value().cameraFromPatient.matrix());
    EXPECT_EQ(once.value().uncertainty.covariance, again.value().uncertainty.covariance);
}

TEST(RegisterVessels, StopKeepsTheBestPoseAtEveryStage)
{
    test::CleanCase clean(5);
    CounterRandom random(2);
    clean.target = traced(clean.target, random);
    const Eigen::Vector3d centroid = centroidInPatient(clean.tree);
    const RegistrationInput input = clean.from(perturbAboutCentroid(clean.truth, centroid, 4.0, 25.0, random));
    const auto whole = registerVessels(input);
    ASSERT_TRUE(whole);
    const auto stepCount = static_cast<int>(whole.value().history.size());
    for (const int stopAt : {1, 2, 5, stepCount / 2, stepCount - 2}) {
        int reports = 0;
        IterationReport last;
        const auto result = registerVessels(input, {}, [&](const IterationReport& report) {
            EXPECT_GE(report.progress, last.progress);
            last = report;
            return ++reports == stopAt ? ObserverDecision::Stop : ObserverDecision::Continue;
        });
        ASSERT_TRUE(result);
        EXPECT_EQ(reports, stopAt) << "went on after the stop";
        EXPECT_EQ(result.value().stopReason, StopReason::StoppedByUser);
        EXPECT_EQ(result.value().history.size(), static_cast<std::size_t>(stopAt));
        EXPECT_FALSE(result.value().trustworthy);
        EXPECT_TRUE(isRigid(result.value().cameraFromPatient));
    }
}

/// Two identical trees side by side, one of them moved away; the image shows two vessels that either tree could match.
struct TwinScene {
    ProjectionCamera camera{-1877.0, 1877.0, 255.5, 255.5, 512, 512};
    RigidTransform truth;
    VesselTree tree;

    TwinScene()
    {
        truth.translation = {0.0, 0.0, 800.0};
        for (const int side : {-1, 1}) {
            VesselBranch branch{side + 2, {}, {}, {}};
            VesselBranch twig{side + 12, {}, {}, {}};
            for (int i = 0; i <= 60; ++i) {
                branch.pointsInPatient.emplace_back(side * 30.0, i - 30.0, 6.0 * std::sin(i / 10.0));
                twig.pointsInPatient.emplace_back(side * 30.0 + 0.3 * i, 0.2 * i, 4.0 * std::sin(i / 9.0));
            }
            tree.branches.push_back(branch);
            tree.branches.push_back(twig);
        }
    }
};

TEST(RegisterVessels, ChosenBranchesDecideBetweenLikePoses)
{
    // Only one of two identical halves is opacified; the other half of the tree would fit equally well.
    const TwinScene scene;
    RegistrationInput input;
    input.tree = scene.tree;
    input.camera = scene.camera;
    input.initialCameraFromPatient = scene.truth;
    for (const Curve2d& curve : projectTree(scene.tree, scene.camera, scene.truth).curves) {
        if (curve.id == 1 || curve.id == 11) {
            input.target.curves.push_back(curve);
        }
    }
    input.auxiliaryBranchIds = {1, 11};
    const auto left = registerVessels(input);
    input.auxiliaryBranchIds = {3, 13};
    const auto right = registerVessels(input);
    ASSERT_TRUE(left && right);
    const Eigen::Vector3d centroid = centroidInPatient(scene.tree);
    EXPECT_TRUE(test::nearPose(left.value().cameraFromPatient, scene.truth, 1.0, 2.0, centroid));
    const Eigen::Vector3d shift =
        right.value().cameraFromPatient * centroid - left.value().cameraFromPatient * centroid;
    EXPECT_NEAR(shift.x(), -60.0, 3.0);
}

/// Arguments of the note on the effect of the subset: its median distance, the same in the fit of all branches, and the
/// degrees and mm between the two poses.
std::vector<double> effectOfChoice(const RegistrationResult& result)
{
    std::vector<double> numbers;
    for (const Message& message : result.warnings) {
        if (message.is(messages::auxiliaryBranchesFitted)) {
            for (const MessageArgument& argument : message.arguments()) {
                numbers.push_back(std::get<Quantity>(argument).value);
            }
        }
    }
    return numbers;
}

TEST(RegisterVessels, ChosenBranchesOfDeformedVesselsFitBetterAndItIsSaid)
{
    test::CleanCase clean(3);
    Curve2d& curve = *std::ranges::max_element(clean.target.curves, {}, [](const Curve2d& each) {
        return (each.pointsPx.back() - each.pointsPx.front()).norm();
    });
    const int moved = curve.id;   // 6 px off the position given by the others
    const Eigen::Vector2d along = (curve.pointsPx.back() - curve.pointsPx.front()).normalized();
    for (Eigen::Vector2d& point : curve.pointsPx) {
        point += 6.0 * Eigen::Vector2d(-along.y(), along.x());
    }
    RegistrationInput input = clean.fromNearby(5);
    const auto plain = registerVessels(input);
    input.auxiliaryBranchIds = {moved};
    const auto chosen = registerVessels(input);
    ASSERT_TRUE(plain && chosen);
    EXPECT_TRUE(effectOfChoice(plain.value()).empty());
    const std::vector<double> effect = effectOfChoice(chosen.value());
    ASSERT_EQ(effect.size(), 4U);
    EXPECT_LT(effect[0], 0.9 * effect[1]);
    EXPECT_GT(effect[3], 0.1);

    RegistrationOptions firmly;
    firmly.angiopose.auxiliaryWeight = 1000.0;
    const auto decided = registerVessels(input, firmly);
    ASSERT_TRUE(decided);
    EXPECT_LT(effectOfChoice(decided.value())[0], 0.6 * effect[1]);

    RegistrationOptions alike;
    alike.angiopose.auxiliaryWeight = 1.0;
    const auto unweighted = registerVessels(input, alike);
    ASSERT_TRUE(unweighted);
    EXPECT_TRUE(effectOfChoice(unweighted.value()).empty());
    EXPECT_LT(meanErrorPx(clean, unweighted.value().cameraFromPatient), 0.5);
}

TEST(RegisterVessels, ChosenBranchesOfRigidVesselsChangeNothing)
{
    const test::CleanCase clean(2);
    RegistrationInput input = clean.fromNearby(6);
    input.auxiliaryBranchIds = {clean.tree.branches[1].id, clean.tree.branches[3].id};
    const auto result = registerVessels(input);
    ASSERT_TRUE(result);
    EXPECT_LT(meanErrorPx(clean, result.value().cameraFromPatient), 0.05);
    EXPECT_TRUE(result.value().trustworthy);
    const std::vector<double> effect = effectOfChoice(result.value());
    ASSERT_EQ(effect.size(), 4U);
    EXPECT_LT(effect[3], 0.5);
}

/// Ids of the branches fed through the branch with the largest territory, not counting the trunk.
std::set<int> largestTerritory(const GrownTree& grown)
{
    std::set<int> largest;
    const auto count = static_cast<int>(grown.takeoffs.size());
    for (int top = 1; top < count; ++top) {
        std::set<int> fed;
        for (int branch = top; branch < count; ++branch) {
            const int parent = grown.takeoffs[static_cast<std::size_t>(branch)].parentIndex;
            if (branch == top ||
                (parent >= 0 && fed.contains(grown.tree.branches[static_cast<std::size_t>(parent)].id))) {
                fed.insert(grown.tree.branches[static_cast<std::size_t>(branch)].id);
            }
        }
        largest = fed.size() > largest.size() ? fed : largest;
    }
    return largest;
}

TEST(RegisterVessels, FindsAPoseFromOneTerritoryAndNamesTheRest)
{
    for (const std::uint64_t seed : {1, 2, 3}) {
        const test::CleanCase clean(seed);
        const GrownTree grown = growTree(seed, {});
        ASSERT_EQ(clean.tree.branches.size(), grown.tree.branches.size());
        const std::set<int> filled = largestTerritory(grown);
        ASSERT_LT(filled.size(), clean.tree.branches.size());
        const Eigen::Vector3d centroid = centroidInPatient(clean.tree);
        CounterRandom random(seed);
        RegistrationInput input = clean.from(perturbAboutCentroid(clean.truth, centroid, 4.0, 12.0, random));
        input.target = traced(clean.target, random);
        std::erase_if(input.target.curves, [&](const Curve2d& curve) { return !filled.contains(curve.id); });
        const auto result = registerVessels(input);
        ASSERT_TRUE(result);
        EXPECT_TRUE(test::nearPose(result.value().cameraFromPatient, clean.truth, 2.0, 5.0, centroid))
            << "tree " << seed;
        EXPECT_TRUE(result.value().trustworthy) << "tree " << seed;
        EXPECT_EQ(clean.tree.branches.size(), result.value().branches.size());
        EXPECT_FALSE(result.value().unopacified.empty()) << "tree " << seed;
    }
}

TEST(RegisterVessels, PutsPointsInOrderThatCameInNone)
{
    const test::CleanCase clean(3);
    CounterRandom random(3);
    RegistrationInput input = clean.from(clean.nearbyStart(random));
    Curve2d all{1, {}, {}};
    for (const Curve2d& curve : traced(clean.target, random).curves) {
        all.pointsPx.insert(all.pointsPx.end(), curve.pointsPx.begin(), curve.pointsPx.end());
    }
    std::ranges::shuffle(all.pointsPx, random);
    input.target.curves = {all};
    const auto result = registerVessels(input);
    ASSERT_TRUE(result);
    EXPECT_LT(meanErrorPx(clean, result.value().cameraFromPatient), 1.0);
    EXPECT_TRUE(result.value().trustworthy);
    ASSERT_FALSE(result.value().warnings.empty());
    EXPECT_TRUE(result.value().warnings.front().is(messages::targetReordered));
}

TEST(RegisterVessels, ExcludedBranchesAreNotUsed)
{
    const test::CleanCase clean(6);
    RegistrationInput input = clean.fromNearby(4);
    input.excludedBranchIds = {clean.tree.branches.back().id};
    const auto result = registerVessels(input);
    ASSERT_TRUE(result);
    EXPECT_EQ(result.value().branches.size(), clean.tree.branches.size() - 1);
    EXPECT_LT(meanErrorPx(clean, result.value().cameraFromPatient), idealErrorPx);
}

}   // namespace
}   // namespace angiopose::core
