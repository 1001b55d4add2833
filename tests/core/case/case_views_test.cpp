#include "core/case/case_views.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

std::shared_ptr<const Angiogram> angiogramOf(int frames)
{
    Angiogram angiogram;
    angiogram.frames.assign(static_cast<std::size_t>(frames), ImageF(8, 8));
    return std::make_shared<const Angiogram>(std::move(angiogram));
}

View viewWith(int frames, double depthMm)
{
    View view;
    view.imageFile.path = "/images/" + std::to_string(frames) + ".dcm";
    view.angiogram = angiogramOf(frames);
    view.frame = frames - 1;
    view.geometry.cArm.primaryAngleDeg = {10.0 * frames, Origin::Header, ""};
    view.cameraFromPatient.translation = {0.0, 0.0, depthMm};
    view.traceOptions.sensitivity = 0.1 * frames;
    view.landmarks = {{{1.0, 2.0, 3.0 * frames}, {4.0, 5.0}, ""}};
    return view;
}

View viewNotFound()
{
    View view;
    view.caseFile.path = "/cases/gone.angiopose";
    return view;
}

Case twoViews()
{
    Case values;
    values.title = "both";
    values.vessels.excludedBranchIds = {4};
    values.options.maxIterations = 17;
    values.views = {viewWith(3, 700.0), viewWith(5, 650.0)};
    values.views[1].caseFile.path = "/cases/other.angiopose";
    return values;
}

TEST(CaseViews, ShowAnotherAndKeepWhatBelongsToTheVessels)
{
    const Case shown = withShownView(twoViews(), 1);
    EXPECT_EQ(shown.shown().imageFile.path, "/images/5.dcm");
    EXPECT_EQ(shown.shown().frame, 4);
    EXPECT_EQ(shown.shown().cameraFromPatient.translation.z(), 650.0);
    EXPECT_TRUE(shown.shown().caseFile.path.empty());   // the view belongs to this case now
    EXPECT_EQ(shown.title, "both");
    EXPECT_EQ(shown.vessels.excludedBranchIds, std::vector<int>{4});
    EXPECT_EQ(shown.options.maxIterations, 17);
    ASSERT_EQ(shown.views.size(), 2U);
    EXPECT_EQ(shown.views[0].imageFile.path, "/images/3.dcm");
}

TEST(CaseViews, AreRegisteredWhereTheyHaveAnImageTheShownOneFirst)
{
    Case values = twoViews();
    values.views.insert(values.views.begin(), viewNotFound());
    values.views.push_back({});
    values.shownView = 2;
    EXPECT_EQ(registeredViews(values), (std::vector<std::size_t>{2, 1}));
    const auto views = viewsAt(values, registeredViews(values));
    ASSERT_EQ(views.size(), 2U);
    EXPECT_EQ(views[0].imageFile.path, "/images/5.dcm");
    EXPECT_EQ(views[1].imageFile.path, "/images/3.dcm");
}

TEST(CaseViews, AnotherTakesThePlaceOfTheShownOneThatGoes)
{
    Case values = twoViews();
    values.views.insert(values.views.begin() + 1, viewNotFound());
    const Case second = withoutView(values, 0);
    ASSERT_EQ(second.views.size(), 2U);
    EXPECT_EQ(second.shown().imageFile.path, "/images/5.dcm");
    const Case first = withoutView(withShownView(values, 2), 0);
    EXPECT_EQ(first.shown().imageFile.path, "/images/5.dcm");
    EXPECT_EQ(first.shownView, 1U);
    const Case last = withoutView(second, 0);
    ASSERT_EQ(last.views.size(), 1U);
    EXPECT_EQ(withoutView(last, 0).views.size(), 1U) << "one is always there";
}

TEST(CaseViews, MovingTheVesselsInOneKeepsTheCamerasWhereTheyAre)
{
    Case values = twoViews();
    values.views.push_back(viewNotFound());
    View& other = values.views[1];
    other.cameraFromPatient.rotation = expSo3({0.1, 0.9, -0.2});
    other.result = RegistrationResult{};
    const RigidTransform wanted{expSo3({0.02, 0.0, 0.3}), {4.0, -7.0, 712.0}};

    const auto moved = viewsAfterMotion(values, wanted);
    ASSERT_EQ(moved.size(), 3U);
    EXPECT_EQ(moved[0].cameraFromPatient.matrix(), wanted.matrix());
    const RigidTransform before = other.cameraFromPatient * values.shown().cameraFromPatient.inverse();
    const RigidTransform after = moved[1].cameraFromPatient * wanted.inverse();
    EXPECT_LT((before.matrix() - after.matrix()).norm(), 1e-9);
    EXPECT_FALSE(moved[1].result);
    EXPECT_TRUE(moved[1].caseFile.path.empty()) << "its file says something else now";
    EXPECT_EQ(moved[2].caseFile, values.views[2].caseFile);
}

TEST(CaseViews, GoToTheirOwnStart)
{
    Case values = twoViews();
    values.views[1].initialCameraFromPatient = RigidTransform{expSo3({0.1, 0.2, 0.3}), {1.0, 2.0, 603.0}};
    const auto views = viewsAtInitialPose(values);
    EXPECT_EQ(views[1].cameraFromPatient.matrix(), values.views[1].initialCameraFromPatient->matrix());
    EXPECT_EQ(views[0].cameraFromPatient.matrix(), values.views[0].cameraFromPatient.matrix()) << "it has none";
}

}   // namespace
}   // namespace angiopose::core
