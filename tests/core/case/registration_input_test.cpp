#include "core/case/registration_input.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

VesselTree oneBranchTree()
{
    VesselTree tree;
    tree.branches.push_back({7, "", {{10, 0, 700}, {14, 3, 706}, {20, 9, 711}}, {}, -1});
    return tree;
}

Vessels smallVessels()
{
    Vessels vessels;
    vessels.tree = std::make_shared<const VesselTree>(oneBranchTree());
    return vessels;
}

const Vessels vessels = smallVessels();

View viewAt(double primaryDeg, double secondaryDeg)
{
    View view;
    CArm& cArm = view.geometry.cArm;
    cArm.sourceToDetectorMm = {1050.0, Origin::User, ""};
    cArm.sourceToIsocenterMm = {750.0, Origin::User, ""};
    cArm.columnSpacingMm = cArm.rowSpacingMm = {0.4, Origin::User, ""};
    cArm.primaryAngleDeg = {primaryDeg, Origin::User, ""};
    cArm.secondaryAngleDeg = {secondaryDeg, Origin::User, ""};
    Angiogram angiogram;
    angiogram.frames.assign(3, ImageF(64, 64));
    angiogram.gantry.table = TablePosition{{0.0, 0.0, 0.0}};   // the table does not move
    view.angiogram = std::make_shared<const Angiogram>(std::move(angiogram));
    view.cameraFromPatient = initialPoseOf(view, vessels).value();
    return view;
}

/// A view of a patient positioned feet first, with the angles from the header.
View viewOfFeetFirst()
{
    View view = viewAt(20.0, 10.0);
    auto angiogram = std::make_shared<Angiogram>(*view.angiogram);
    angiogram->gantry.patientPosition = PatientPosition::FFS;
    view.angiogram = std::move(angiogram);
    view.geometry.cArm.primaryAngleDeg.origin = view.geometry.cArm.secondaryAngleDeg.origin = Origin::Header;
    return view;
}

const std::vector<Centerline2d> targets(2);

}   // namespace

TEST(RegistrationInput, KnowsHowElseAnglesOfAHeaderMayBeMeant)
{
    View view = viewOfFeetFirst();
    const auto reading = makeRegistrationInput(view, vessels, {}).value().tableAngles;
    ASSERT_TRUE(reading);
    EXPECT_NEAR(reading->angles.primaryDeg, -20.0, 1e-9);
    view.geometry.cArm.primaryAngleDeg.origin = Origin::User;
    EXPECT_FALSE(makeRegistrationInput(view, vessels, {}).value().tableAngles) << "who types angles means them";
    view = viewOfFeetFirst();
    view.initialCameraFromPatient = view.cameraFromPatient;
    EXPECT_FALSE(makeRegistrationInput(view, vessels, {}).value().tableAngles) << "the start does not rest on them";
}

TEST(JointInputs, PutTheOtherViewWhereTheGantrysTurnLeads)
{
    std::vector<View> views{viewAt(-30.0, 0.0), viewAt(45.0, 20.0)};
    views[0].cameraFromPatient.translation += Eigen::Vector3d(5.0, -3.0, 12.0);
    views[1].cameraFromPatient = {};   // the previous pose does not matter
    const auto inputs = makeJointInputs(views, vessels, targets);
    ASSERT_TRUE(inputs) << inputs.error().message;
    const RigidTransform between =
        inputs.value().views[1].initialCameraFromPatient * inputs.value().views[0].initialCameraFromPatient.inverse();
    const RigidTransform wanted =
        initialPoseOf(views[1], vessels).value() * initialPoseOf(views[0], vessels).value().inverse();
    EXPECT_LT((between.matrix() - wanted.matrix()).norm(), 1e-9);
    EXPECT_EQ(inputs.value().views[0].initialCameraFromPatient.matrix(), views[0].cameraFromPatient.matrix());
}

TEST(JointInputs, TakeTheGantryForTheGeometryEvenWhereTheVesselsHaveTheirOwnAxes)
{
    std::vector<View> views{viewAt(-30.0, 0.0), viewAt(45.0, 20.0)};
    const RigidTransform between =
        initialPoseOf(views[1], vessels).value() * initialPoseOf(views[0], vessels).value().inverse();
    const RigidTransform ownAxes{expSo3({0.3, -1.1, 0.7}), {40.0, -5.0, 300.0}};
    for (View& view : views) {
        // A guessed pose of the vessels.
        view.initialCameraFromPatient = initialPoseOf(viewAt(3.0, 4.0), vessels).value() * ownAxes;
        view.cameraFromPatient = *view.initialCameraFromPatient;
    }
    const auto inputs = makeJointInputs(views, vessels, targets);
    ASSERT_TRUE(inputs);
    const RigidTransform found =
        inputs.value().views[1].initialCameraFromPatient * inputs.value().views[0].initialCameraFromPatient.inverse();
    EXPECT_LT((found.matrix() - between.matrix()).norm(), 1e-9);
}

TEST(JointInputs, TakeTheInitialPosesWhereAnglesAreMissing)
{
    std::vector<View> views{viewAt(-30.0, 0.0), viewAt(45.0, 20.0)};
    for (View& view : views) {
        view.initialCameraFromPatient = initialPoseOf(view, vessels).value();
        view.geometry.cArm.primaryAngleDeg = {};
    }
    const auto inputs = makeJointInputs(views, vessels, targets);
    ASSERT_TRUE(inputs) << inputs.error().message;
    EXPECT_LT((inputs.value().views[1].initialCameraFromPatient.matrix() - views[1].initialCameraFromPatient->matrix())
                  .norm(),
              1e-9);
}

TEST(JointInputs, NameTheViewThatLacksSomething)
{
    std::vector<View> views{viewAt(0.0, 0.0), viewAt(90.0, 0.0)};
    views[1].geometry.cArm.secondaryAngleDeg = {};
    const auto inputs = makeJointInputs(views, vessels, targets);
    ASSERT_FALSE(inputs);
    EXPECT_NE(inputs.error().message.text().find("View 2"), std::string::npos);
}

TEST(WithFrame, TurnsThePosesWithTheGantry)
{
    View run = viewAt(10.0, 0.0);
    Angiogram turning = *run.angiogram;
    turning.gantry.angleIncrementsDeg = {{0.0, 0.0}, {15.0, 0.0}, {30.0, 5.0}};
    run.angiogram = std::make_shared<const Angiogram>(std::move(turning));
    EXPECT_DOUBLE_EQ(*cArmOfFrame(run).primaryAngleDeg.value, 10.0);
    const View later = withFrame(run, 2);
    EXPECT_DOUBLE_EQ(*cArmOfFrame(later).primaryAngleDeg.value, 40.0);
    EXPECT_LT((later.cameraFromPatient.matrix() - initialPoseOf(later, vessels).value().matrix()).norm(), 1e-9);
    EXPECT_LT((withFrame(later, 0).cameraFromPatient.matrix() - run.cameraFromPatient.matrix()).norm(), 1e-9);
}

TEST(WithFrame, LeavesThePoseAloneWhereTheGantryStood)
{
    const View run = viewAt(10.0, 0.0);
    EXPECT_EQ(withFrame(run, 2).cameraFromPatient.matrix(), run.cameraFromPatient.matrix());
    EXPECT_EQ(withFrame(run, 2).frame, 2);
}

}   // namespace angiopose::core
