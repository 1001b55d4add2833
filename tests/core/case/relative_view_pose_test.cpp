#include "core/case/relative_view_pose.h"

#include "core/case/initial_pose.h"

#include <gtest/gtest.h>
#include <algorithm>

namespace angiopose::core {
namespace {

Vessels vesselsOfSteps()
{
    VesselTree tree;
    tree.branches.push_back({7, "", {{10, 0, 700}, {14, 3, 706}, {20, 9, 711}}, {}, -1});
    Vessels made;
    made.tree = std::make_shared<const VesselTree>(std::move(tree));
    return made;
}

const Vessels someVessels = vesselsOfSteps();

SourcedValue<double> knownFromHeader(double value)
{
    return {value, Origin::Header, ""};
}

/// A view as defined by the header of a room; `table`: position of the isocenter in the patient.
View roomView(double primaryDeg, std::optional<Eigen::Vector3d> table, double objectMm = 700.0)
{
    View view;
    CArm& cArm = view.geometry.cArm;
    cArm.sourceToDetectorMm = knownFromHeader(1050.0);
    cArm.sourceToIsocenterMm = knownFromHeader(750.0);
    cArm.sourceToObjectMm = knownFromHeader(objectMm);
    cArm.columnSpacingMm = cArm.rowSpacingMm = knownFromHeader(0.4);
    cArm.primaryAngleDeg = knownFromHeader(primaryDeg);
    cArm.secondaryAngleDeg = knownFromHeader(10.0);
    Angiogram angiogram;
    angiogram.frames.assign(3, ImageF(64, 64));
    if (table) {
        angiogram.gantry.table = TablePosition{*table};
    }
    view.angiogram = std::make_shared<const Angiogram>(std::move(angiogram));
    view.cameraFromPatient = initialPoseOf(view, someVessels).value();
    return view;
}

void changeRun(View& view, const auto& edit)
{
    auto angiogram = std::make_shared<Angiogram>(*view.angiogram);
    edit(*angiogram);
    view.angiogram = std::move(angiogram);
}

bool isNotedBy(const RelativeViewPose& step, std::string_view id)
{
    return std::ranges::any_of(step.notes, [&](const Message& note) { return note.id() == id; });
}

TEST(InitialPose, HasTheVesselsInTheObjectPlaneAndTurnsAboutTheIsocenter)
{
    const View view = roomView(20.0, {});
    const Eigen::Vector3d centroid = centroidInPatient(*someVessels.tree);
    EXPECT_NEAR((view.cameraFromPatient * centroid - Eigen::Vector3d(0, 0, 700)).norm(), 0.0, 1e-9);
    View run = view;
    changeRun(run, [](Angiogram& angiogram) { angiogram.gantry.angleIncrementsDeg = {{0, 0}, {90, 0}, {180, 0}}; });
    // The isocenter keeps its place; the vessels, 50 mm closer to the source, do not.
    const View turned = withFrame(run, 2);
    const Eigen::Vector3d isocenter = view.cameraFromPatient.inverse() * Eigen::Vector3d(0, 0, 750);
    EXPECT_NEAR((turned.cameraFromPatient * isocenter - Eigen::Vector3d(0, 0, 750)).norm(), 0.0, 1e-9);
}

TEST(StepToView, TheTableCarriesTheIsocenterThroughThePatient)
{
    const Eigen::Vector3d before(10.0, -20.0, 30.0), after(-45.0, 12.0, 95.0), heart(7.0, 8.0, 690.0);
    const View first = roomView(-30.0, before), view = roomView(45.0, after);
    const auto step = relativeViewPose(first, view, someVessels);
    ASSERT_TRUE(step) << step.error().message;
    const RigidTransform wanted = cameraFromPatient(view.geometry.cArm, heart + after).value() *
                                  cameraFromPatient(first.geometry.cArm, heart + before).value().inverse();
    EXPECT_LT((step.value().viewFromFirst.matrix() - wanted.matrix()).norm(), 1e-9);
    EXPECT_GE(step.value().spread.shiftMm.minCoeff(), 5.0);
    EXPECT_LE(step.value().spread.shiftMm.maxCoeff(), 8.0);
    EXPECT_GE(step.value().spread.rotationDeg, 0.5);
    EXPECT_LE(step.value().spread.rotationDeg, 1.0);
    EXPECT_TRUE(step.value().notes.empty());
}

TEST(StepToView, WithoutATableOnlyTheTurnIsKnown)
{
    View first = roomView(-30.0, {}), view = roomView(45.0, {}, 820.0);
    first.cameraFromPatient.translation += Eigen::Vector3d(5.0, -3.0, 12.0);
    for (const bool isHalfKnown : {false, true}) {
        if (isHalfKnown) {   // the other view's table has a different origin
            changeRun(first, [](Angiogram& run) {
                run.gantry.table = TablePosition{{0, 0, 0}, TablePosition::Tags::Siemens};
            });
            changeRun(view, [](Angiogram& run) {
                run.gantry.table = TablePosition{{0, 0, 0}, TablePosition::Tags::Standard};
            });
        }
        const auto step = relativeViewPose(first, view, someVessels);
        ASSERT_TRUE(step);
        EXPECT_EQ(step.value().spread.shiftMm, Eigen::Vector3d(60.0, 60.0, 30.0));
        EXPECT_TRUE(isNotedBy(step.value(), "geometry.table-unknown"));
        const Eigen::Vector3d centroid = centroidInPatient(*someVessels.tree);
        const Eigen::Vector3d there = step.value().viewFromFirst * (first.cameraFromPatient * centroid);
        EXPECT_NEAR((there - Eigen::Vector3d(0, 0, 820)).norm(), 0.0, 1e-9) << "where the view starts by itself";
    }
}

TEST(StepToView, AnObjectPlaneThatDiffersIsNoIsocenter)
{
    std::vector<View> views{roomView(-30.0, Eigen::Vector3d(0, 0, 0), 683.0),
                            roomView(45.0, Eigen::Vector3d(0, 0, 9), 815.0)};
    for (View& view : views) {
        view.geometry.cArm.sourceToIsocenterMm = {};
        assumeIsocenter(view.geometry.cArm);
        EXPECT_EQ(view.geometry.cArm.sourceToIsocenterMm.origin, Origin::Assumed);
    }
    const auto step = relativeViewPose(views[0], views[1], someVessels);
    ASSERT_TRUE(step);
    EXPECT_FALSE(step.value().spread.predictsPosition());
    EXPECT_TRUE(isNotedBy(step.value(), "geometry.isocenter-unknown"));
    views[1].geometry.cArm.sourceToIsocenterMm.value = 683.2;
    EXPECT_TRUE(relativeViewPose(views[0], views[1], someVessels).value().spread.predictsPosition())
        << "the same plane may be it";
}

TEST(StepToView, ATableThatMovedTellsNoShift)
{
    const View first = roomView(-30.0, Eigen::Vector3d(0, 0, 0));
    View view = roomView(45.0, Eigen::Vector3d(5, 0, 0));
    changeRun(view, [](Angiogram& run) { run.gantry.tableMoves = true; });
    const auto step = relativeViewPose(first, view, someVessels);
    ASSERT_TRUE(step);
    EXPECT_EQ(step.value().spread.shiftMm, Eigen::Vector3d::Constant(50.0));
    EXPECT_TRUE(isNotedBy(step.value(), "geometry.table-moved-in-view"));
}

TEST(StepToView, PlanesTakenTogetherAndFramesOfOneRunShareTheIsocenter)
{
    View first = roomView(-30.0, {}), view = roomView(45.0, {});
    changeRun(first, [](Angiogram& run) { run.gantry.biplane = BiplaneTime{'A', "20240229", 3600.0}; });
    changeRun(view, [](Angiogram& run) { run.gantry.biplane = BiplaneTime{'B', "20240229", 3600.4}; });
    EXPECT_EQ(relativeViewPose(first, view, someVessels).value().spread.shiftMm, Eigen::Vector3d::Constant(1.5));
    EXPECT_TRUE(relativeViewPose(first, view, someVessels).value().notes.empty());
    changeRun(view, [](Angiogram& run) { run.gantry.biplane->timeS = 3690.0; });
    EXPECT_EQ(relativeViewPose(first, view, someVessels).value().spread.shiftMm.x(), 60.0) << "the next acquisition";
    View later = first;
    changeRun(later, [](Angiogram& run) { run.identity.sopInstanceUid = "1.2.3"; });
    View earlier = later;
    EXPECT_EQ(relativeViewPose(earlier, later, someVessels).value().spread.shiftMm, Eigen::Vector3d::Constant(1.5));
}

TEST(StepToView, TablesOfTwoStudiesTellNothing)
{
    View first = roomView(-30.0, Eigen::Vector3d(0, 0, 0)), view = roomView(45.0, Eigen::Vector3d(5, 0, 0));
    changeRun(first, [](Angiogram& run) { run.identity.studyUid = "1.2.3"; });
    changeRun(view, [](Angiogram& run) { run.identity.studyUid = "1.2.4"; });
    EXPECT_TRUE(isNotedBy(relativeViewPose(first, view, someVessels).value(), "geometry.table-unknown"));
}

}   // namespace
}   // namespace angiopose::core
