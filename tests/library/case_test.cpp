#include "tests/library/small_case.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

namespace angiopose {
namespace {

namespace fs = std::filesystem;

class CaseOfLibrary : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }
    std::string at(const std::string& name) const { return (folder / name).string(); }

    const fs::path folder = fs::temp_directory_path() / ("angiopose-library-" + std::to_string(getpid()));
};

TEST_F(CaseOfLibrary, OfArraysIsWrittenWithItsInputsAndOpensAgain)
{
    SimulatedCase simulated = test::smallCase();
    writeCase(simulated.session, at("made.angiopose"));
    EXPECT_TRUE(fs::exists(at("made.tree.vtp")));
    EXPECT_TRUE(fs::exists(at("made.angiogram.dcm")));
    const Case read = readCase(at("made.angiopose"));
    EXPECT_EQ(simulated.session.title(), read.title());
    EXPECT_EQ(simulated.session.initialPose(), read.initialPose());
    EXPECT_EQ(simulated.session.tree().points, read.tree().points);
    EXPECT_EQ(simulated.session.frame(), read.frame());
    EXPECT_TRUE(read.warnings().empty());
}

TEST_F(CaseOfLibrary, OfTwoFilesIsTheCaseOfTheseFiles)
{
    SimulatedCase simulated = test::smallCase();
    writeCase(simulated.session, at("made.angiopose"));
    Case fromFiles = readCase(at("made.tree.vtp"), at("made.angiogram.dcm"));
    fromFiles.setInitialPose(simulated.session.initialPose());
    Case fromCase = readCase(at("made.angiopose"));
    EXPECT_EQ(registerCase(fromCase).cameraFromPatient, registerCase(fromFiles).cameraFromPatient);
    writeResult(fromCase, at("result.json"));
    EXPECT_EQ(fromCase.cameraFromPatient(), readPose(at("result.json")));
    writeCase(fromFiles, at("again.angiopose"));
    EXPECT_EQ(fromFiles.cameraFromPatient(), readCase(at("again.angiopose")).cameraFromPatient());
}

TEST_F(CaseOfLibrary, KeepsAGivenTarget)
{
    SimulatedCase simulated = test::smallCase();
    simulated.session.setTarget(simulated.trueTarget);
    writeCase(simulated.session, at("made.angiopose"));
    EXPECT_EQ(simulated.trueTarget.points.size(), targetOf(readCase(at("made.angiopose"))).points.size());
}

TEST_F(CaseOfLibrary, WithoutGeometryAsksForAStartPose)
{
    const SimulatedCase simulated = test::smallCase();
    const Angiogram run = simulated.session.angiogram();
    Case bare(simulated.session.tree(), Angiogram({run.frame(run.suggestedFrame())}, run.polarity()));
    bare.setCamera(simulated.session.camera());
    try {
        registerCase(bare);
        FAIL() << "a pose was made up";
    } catch (const Error& error) {
        EXPECT_EQ("library.no-start", error.id());
    }
    bare.setInitialPose(simulated.session.initialPose());
    EXPECT_LT(registerCase(bare).metrics.medianPx, 5.0);
}

TEST_F(CaseOfLibrary, ACArmGivesAPlainImageCameraAndInitialPose)
{
    const Case known = test::smallCase().session;
    const Angiogram run = known.angiogram();
    Case plain(known.tree(), Angiogram({run.frame(run.suggestedFrame())}, run.polarity()));
    EXPECT_THROW(plain.camera(), Error);
    plain.setCArm(known.cArm());
    EXPECT_EQ(known.camera().fx, plain.camera().fx);
    EXPECT_EQ(plain.initialPose(), plain.cameraFromPatient());
    EXPECT_LT((plain.initialPose() - known.initialPose()).norm(), 100.0);
}

TEST_F(CaseOfLibrary, RefusesTheCameraOfAnotherImageAndBranchesItDoesNotHave)
{
    Case session = test::smallCase().session;
    const int width = session.camera().width;
    EXPECT_THROW(session.setCamera({-3000.0, 3000.0, 150.0, 150.0, 300, 300}), Error);
    EXPECT_EQ(width, session.camera().width);
    EXPECT_THROW(session.setExcludedBranchIds({987}), Error);
    const int first = session.tree().branchIds.front();
    session.setExcludedBranchIds({first});
    EXPECT_EQ(std::vector<int>{first}, inputOf(session).excludedBranchIds);
    EXPECT_THROW(Case(VesselTree(), session.angiogram()), Error);
}

TEST_F(CaseOfLibrary, CopiesGoTheirOwnWays)
{
    const Case first = test::smallCase().session;
    Case second = first;
    second.setTitle("another");
    Pose moved = second.cameraFromPatient();
    moved(2, 3) += 10.0;
    second.setCameraFromPatient(moved);
    EXPECT_NE(first.title(), second.title());
    EXPECT_NE(first.cameraFromPatient(), second.cameraFromPatient());
    EXPECT_EQ(first.angiogram().pixels(0).data(), second.angiogram().pixels(0).data());
}

/// Projections of the tree of `view` with its own camera.
Centerline2d projections(const RegistrationInput& view, const Pose& cameraFromPatient)
{
    Centerline2d projected;
    for (std::size_t i = 0; i < view.tree.points.size(); ++i) {
        if (const auto pixel = project(view.camera, cameraFromPatient, view.tree.points[i])) {
            projected.points.push_back(*pixel);
            projected.curveIds.push_back(view.tree.branchIds[i]);
        }
    }
    return projected;
}

TEST_F(CaseOfLibrary, TwoViewsAgreeOnOnePlace)
{
    const SimulatedCase one = test::smallCase();
    RegistrationInput first = inputOf(one.session);
    first.image = {};
    RegistrationInput second = first;
    Pose turn = Pose::Identity();   // a second camera at a right angle, rotated about the vessels
    const double depth = one.session.initialPose()(2, 3);
    turn.topLeftCorner<3, 3>() << 0, 0, 1, 0, 1, 0, -1, 0, 0;
    turn.topRightCorner<3, 1>() << -depth, 0, depth;
    second.initialCameraFromPatient = turn * first.initialCameraFromPatient;
    first.target = projections(first, one.trueCameraFromPatient);
    second.target = projections(second, turn * one.trueCameraFromPatient);

    const MultiViewResult joint = registerViews({first, second});

    ASSERT_EQ(2U, joint.views.size());
    EXPECT_LT((joint.views[0].cameraFromPatient - one.trueCameraFromPatient).norm(), 0.5);
    EXPECT_LT((joint.views[1].cameraFromPatient - turn * one.trueCameraFromPatient).norm(), 0.5);
    EXPECT_LT(joint.uncertainty.depthMm, 0.5);
}

}   // namespace
}   // namespace angiopose
