#include "core/registration/methods/method.h"
#include "core/registration/registration.h"
#include "core/simulation/deform_tree.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <map>

using namespace angiopose;

// Characteristic behavior of CVO, matched branches and graph matching, and the effect of their options.

namespace {

using namespace core;
using test::CleanCase;

RegistrationOptions quickBy(std::string_view method)
{
    RegistrationOptions options;
    options.method = method;
    return options;
}

MethodSolution solutionOf(const RegistrationInput& input, const RegistrationOptions& options)
{
    const Result<RegistrationProblem> problem = makeProblem(input, options);
    EXPECT_TRUE(problem) << (problem ? "" : problem.error().message.text());
    const IterationObserver none;
    ProgressLog progress(problem.value(), none);
    return findMethod(options.method)->solve(problem.value(), options, progress);
}

/// The clean case with an initial pose shifted to the right by `rightMm`, at the true angles.
RegistrationInput shiftedStart(const CleanCase& clean, double rightMm)
{
    return clean.from(RigidTransform{Eigen::Matrix3d::Identity(), Eigen::Vector3d(rightMm, 0.0, 0.0)} * clean.truth);
}

TEST(GraphMethods, FindThePoseFromANearbyStart)
{
    const std::map<std::string_view, double> limitsPx{{"cvo", 1.0}, {"matched-branches", 1.0}, {"graph-matching", 0.5}};
    const CleanCase clean(2);
    const RegistrationInput input = clean.fromNearby(5);
    for (const auto& [method, limitPx] : limitsPx) {
        EXPECT_LT(meanErrorPx(clean, solutionOf(input, quickBy(method)).cameraFromPatient), limitPx) << method;
    }
}

TEST(Cvo, ItsOptionsCount)
{
    const CleanCase clean(2);
    const RegistrationInput input = clean.fromNearby(5);
    RegistrationOptions options = quickBy("cvo");
    options.cvo.iterations = 3;
    const MethodSolution few = solutionOf(input, options);
    EXPECT_EQ(few.stopReason, StopReason::IterationLimit);
    EXPECT_GT(meanErrorPx(clean, few.cameraFromPatient), 2.0);
    options.cvo.directions = false;
    EXPECT_NE(solutionOf(input, options).cameraFromPatient.matrix(), few.cameraFromPatient.matrix());
}

// A first-order flow hardly moves along the ray (ALGORITHMS §3.16).
TEST(Cvo, LeavesTheDepthNearTheStarts)
{
    const CleanCase clean(2);
    const RigidTransform start =
        RigidTransform{Eigen::Matrix3d::Identity(), Eigen::Vector3d(2.0, 1.0, 20.0)} * clean.truth;
    const RigidTransform pose = solutionOf(clean.from(start), quickBy("cvo")).cameraFromPatient;
    const Eigen::Vector3d centroid = centroidInPatient(clean.tree);
    EXPECT_GT(std::abs((pose * centroid - clean.truth * centroid).z()), 5.0);
}

TEST(Cvo, SaysWhenNothingIsWithinReach)
{
    const CleanCase clean(2);
    const MethodSolution solution = solutionOf(shiftedStart(clean, 600.0), quickBy("cvo"));
    EXPECT_EQ(solution.stopReason, StopReason::NoImprovement);
}

TEST(MatchedBranches, AreNoneBeyondTheReach)
{
    const CleanCase clean(2);
    const MethodSolution solution = solutionOf(shiftedStart(clean, 600.0), quickBy("matched-branches"));
    EXPECT_EQ(solution.stopReason, StopReason::NoImprovement);
}

TEST(MatchedBranches, TellHowFarTheVesselsMoved)
{
    CleanCase clean(2);
    CounterRandom random(7);
    clean.target = projectTree(deformed(clean.tree, 2.0, random), clean.camera, clean.truth);
    RegistrationOptions options = quickBy("matched-branches");
    const MethodSolution warped = solutionOf(clean.from(clean.truth), options);
    ASSERT_EQ(warped.warnings.size(), 1U);
    EXPECT_EQ(warped.warnings.front().id(), "result.matched-branches-moved");
    EXPECT_EQ(warped.warnings.front().severity(), Severity::Note);
    options.branches.motion = false;
    const MethodSolution rigid = solutionOf(clean.from(clean.truth), options);
    EXPECT_TRUE(rigid.warnings.empty());
    EXPECT_EQ(rigid.cameraFromPatient.matrix(), warped.cameraFromPatient.matrix());
}

// Matched pairs constrain the scale where nearest points alone let the tree run away (compare DtIcp).
TEST(MatchedBranches, KeepTheDepthThoughTheImageShowsHalf)
{
    CleanCase clean(1);
    clean.target.curves.resize(clean.target.curves.size() / 2);
    CounterRandom random(1);
    const RigidTransform pose =
        solutionOf(clean.from(clean.nearbyStart(random)), quickBy("matched-branches")).cameraFromPatient;
    const Eigen::Vector3d centroid = centroidInPatient(clean.tree);
    EXPECT_LT(std::abs((pose * centroid - clean.truth * centroid).z()), 100.0);
}

// Nearest-point methods fail here: the vessels are 117 px away from their initial projection.
TEST(GraphMatching, FindsItsWayFromFarBeside)
{
    const CleanCase clean(2);
    const RegistrationInput input = shiftedStart(clean, 50.0);
    EXPECT_LT(meanErrorPx(clean, solutionOf(input, quickBy("graph-matching")).cameraFromPatient), 1.0);
    RegistrationOptions near = quickBy("graph-matching");
    near.graph.reachPx = 20.0;
    near.graph.hypotheses = 10;
    EXPECT_GT(meanErrorPx(clean, solutionOf(input, near).cameraFromPatient), 5.0);
}

TEST(GraphMatching, RefinesTheStartWhereTheImageHasNoRoots)
{
    const CleanCase clean(2);
    RegistrationOptions options = quickBy("graph-matching");
    options.graph.reachPx = 1.0;
    const RegistrationInput input = clean.fromNearby(5);
    EXPECT_LT(meanErrorPx(clean, solutionOf(input, options).cameraFromPatient),
              meanErrorPx(clean, input.initialCameraFromPatient));
}

TEST(GraphMethods, HearAStopAtOnce)
{
    const CleanCase clean(3);
    const RegistrationInput input = clean.fromNearby(6);
    for (const std::string_view method : {"cvo", "matched-branches", "graph-matching"}) {
        int heard = 0;
        const auto result = registerVessels(input, quickBy(method), [&](const IterationReport&) {
            return ++heard == 2 ? ObserverDecision::Stop : ObserverDecision::Continue;
        });
        ASSERT_TRUE(result) << method;
        EXPECT_EQ(result.value().stopReason, StopReason::StoppedByUser) << method;
        EXPECT_EQ(heard, 2) << method;
    }
}

}   // namespace
