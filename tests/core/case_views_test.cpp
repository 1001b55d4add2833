#include "core/case_views.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

std::shared_ptr<const Angiogram> angiogramOf(int frames)
{
    Angiogram angiogram;
    angiogram.frames.assign(static_cast<std::size_t>(frames), ImageF(8, 8));
    return std::make_shared<const Angiogram>(std::move(angiogram));
}

RegistrationCase viewWith(int frames, double depthMm)
{
    RegistrationCase view;
    view.imageFile.path = "/images/" + std::to_string(frames) + ".dcm";
    view.angiogram = angiogramOf(frames);
    view.frame = frames - 1;
    view.cArm.primaryAngleDeg = {10.0 * frames, Origin::Header, ""};
    view.cameraFromPatient.translation = {0.0, 0.0, depthMm};
    view.traceOptions.sensitivity = 0.1 * frames;
    view.landmarks = {{{1.0, 2.0, 3.0 * frames}, {4.0, 5.0}, ""}};
    return view;
}

RegistrationCase twoViews()
{
    RegistrationCase values = viewWith(3, 700.0);
    values.title = "both";
    values.excludedBranchIds = {4};
    values.options.maxIterations = 17;
    values.otherViews = {
        {{"/cases/other.angiopose", ""}, std::make_shared<const RegistrationCase>(viewWith(5, 650.0))}};
    return values;
}

TEST(CaseViews, ShowAnotherAndKeepWhatBelongsToTheVessels)
{
    const RegistrationCase shown = showingView(twoViews(), 0);
    EXPECT_EQ(shown.imageFile.path, "/images/5.dcm");
    EXPECT_EQ(shown.frame, 4);
    EXPECT_EQ(shown.cameraFromPatient.translation.z(), 650.0);
    EXPECT_EQ(shown.traceOptions.sensitivity, 0.5);
    EXPECT_EQ(shown.title, "both");
    EXPECT_EQ(shown.excludedBranchIds, std::vector<int>{4});
    EXPECT_EQ(shown.options.maxIterations, 17);
    ASSERT_EQ(shown.otherViews.size(), 1U);
    EXPECT_TRUE(shown.otherViews[0].file.path.empty());   // it stands in this case now
    EXPECT_EQ(shown.otherViews[0].view->imageFile.path, "/images/3.dcm");
    EXPECT_FALSE(shown.otherViews[0].view->tree);
}

TEST(CaseViews, ShowingTwiceIsWhereItBegan)
{
    const RegistrationCase before = twoViews();
    const RegistrationCase after = showingView(showingView(before, 0), 0);
    EXPECT_EQ(after.imageFile, before.imageFile);
    EXPECT_EQ(after.angiogram, before.angiogram);
    EXPECT_EQ(after.frame, before.frame);
    EXPECT_EQ(after.cameraFromPatient.matrix(), before.cameraFromPatient.matrix());
    EXPECT_EQ(after.cArm.primaryAngleDeg.value, before.cArm.primaryAngleDeg.value);
    EXPECT_EQ(after.landmarks, before.landmarks);
    EXPECT_EQ(after.otherViews[0].view->imageFile, before.otherViews[0].view->imageFile);
}

TEST(CaseViews, MakeACaseOfEachThatHasAnImage)
{
    RegistrationCase values = twoViews();
    values.otherViews.push_back({{"/cases/gone.angiopose", ""}, nullptr});
    values.otherViews.push_back({{}, std::make_shared<const RegistrationCase>()});
    const auto cases = casesOfViews(values);
    ASSERT_EQ(cases.size(), 2U);
    EXPECT_EQ(cases[0].imageFile.path, "/images/3.dcm");
    EXPECT_EQ(cases[1].imageFile.path, "/images/5.dcm");
    EXPECT_EQ(cases[1].excludedBranchIds, values.excludedBranchIds);
}

TEST(CaseViews, MovingTheVesselsInOneKeepsTheCamerasWhereTheyAre)
{
    RegistrationCase values = twoViews();
    RegistrationCase other = *values.otherViews[0].view;
    other.cameraFromPatient.rotation = expSo3({0.1, 0.9, -0.2});
    other.result = RegistrationResult{};
    values.otherViews[0].view = std::make_shared<const RegistrationCase>(other);
    values.otherViews.push_back({{"/cases/gone.angiopose", ""}, nullptr});
    const RigidTransform wanted{expSo3({0.02, 0.0, 0.3}), {4.0, -7.0, 712.0}};

    const auto moved = movedAlong(values, wanted);
    ASSERT_EQ(moved.size(), 2U);
    const RegistrationCase& view = *moved[0].view;
    const RigidTransform before = other.cameraFromPatient * values.cameraFromPatient.inverse();
    const RigidTransform after = view.cameraFromPatient * wanted.inverse();
    EXPECT_LT((before.matrix() - after.matrix()).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_GT((view.cameraFromPatient.matrix() - other.cameraFromPatient.matrix()).cwiseAbs().maxCoeff(), 1.0);
    EXPECT_FALSE(view.result);
    EXPECT_TRUE(moved[0].file.path.empty());   // no longer what its own case file says
    EXPECT_EQ(moved[1], values.otherViews[1]);
}

TEST(CaseViews, EachGoesBackToItsOwnStartPose)
{
    RegistrationCase values = twoViews();
    RegistrationCase other = *values.otherViews[0].view;
    other.hasInitialPose = true;
    other.initialCameraFromPatient.translation = {1.0, 2.0, 640.0};
    values.otherViews[0].view = std::make_shared<const RegistrationCase>(other);
    EXPECT_EQ(atStart(values)[0].view->cameraFromPatient.matrix(), other.initialCameraFromPatient.matrix());
}

}   // namespace
}   // namespace angiopose::core