#include "io/case_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;

std::string phantomPath(int view)
{
    return test::dataFile("coronary-phantom-xa/cases/IM" + std::to_string(view) + ".angiopose").string();
}

core::RegistrationCase loadedFrom(const std::string& path, core::Messages& warnings)
{
    auto loaded = io::loadCase(path, warnings);
    EXPECT_TRUE(loaded) << loaded.error().message;
    return loaded ? std::move(loaded).value() : core::RegistrationCase{};
}

core::RegistrationCase loadedFrom(const std::string& path)
{
    core::Messages warnings;
    return loadedFrom(path, warnings);
}

/// IM4 with IM3 as another view that stands in the case.
core::RegistrationCase twoViews()
{
    core::RegistrationCase values = loadedFrom(phantomPath(4));
    core::RegistrationCase other = loadedFrom(phantomPath(3));
    other.frame = 2;
    other.cameraFromPatient.translation.x() = 1.0 / 3.0;
    other.traceOptions.sensitivity = 1.1;
    values.otherViews = {{{}, std::make_shared<const core::RegistrationCase>(other)}};
    return values;
}

core::RegistrationCase withCurves(core::RegistrationCase view)
{
    view.givenTarget = std::make_shared<const core::Centerline2d>(
        core::Centerline2d{{core::Curve2d{4, {{1.5, 2.5}, {7.0, 9.0}}, {1.5, 2.0}}}});
    view.editedFrame = view.frame;
    return view;
}

TEST(CaseViews, StandInTheCaseToTheLastBit)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    const core::RegistrationCase original = twoViews();
    ASSERT_TRUE(io::saveCase(original, folder.file("both.angiopose")));
    core::Messages warnings;
    const core::RegistrationCase copy = loadedFrom(folder.file("both.angiopose"), warnings);
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    ASSERT_EQ(copy.otherViews.size(), 1U);
    EXPECT_TRUE(copy.otherViews[0].file.path.empty());
    const core::RegistrationCase& view = *copy.otherViews[0].view;
    const core::RegistrationCase& wanted = *original.otherViews[0].view;
    ASSERT_TRUE(view.angiogram);
    EXPECT_EQ(view.imageFile, wanted.imageFile);
    EXPECT_EQ(view.frame, 2);
    EXPECT_EQ(view.cameraFromPatient.matrix(), wanted.cameraFromPatient.matrix());
    EXPECT_EQ(view.initialCameraFromPatient.matrix(), wanted.initialCameraFromPatient.matrix());
    EXPECT_EQ(view.cameraOverride, wanted.cameraOverride);
    EXPECT_EQ(view.cArm.primaryAngleDeg.value, wanted.cArm.primaryAngleDeg.value);
    EXPECT_EQ(view.traceOptions, wanted.traceOptions);
    EXPECT_EQ(copy.cameraFromPatient.matrix(), original.cameraFromPatient.matrix());
}

TEST(CaseViews, OfACaseFileAreReadWithItsGeometryButWithTheCasesVessels)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    core::RegistrationCase values = loadedFrom(phantomPath(4));
    values.otherViews = {{{phantomPath(3), ""}, nullptr}};
    ASSERT_TRUE(io::saveCase(values, folder.file("both.angiopose")));
    const core::RegistrationCase copy = loadedFrom(folder.file("both.angiopose"));
    ASSERT_EQ(copy.otherViews.size(), 1U);
    EXPECT_TRUE(fs::equivalent(copy.otherViews[0].file.path, phantomPath(3)));
    ASSERT_TRUE(copy.otherViews[0].view && copy.otherViews[0].view->angiogram);
    EXPECT_EQ(copy.otherViews[0].file.sha256.size(), 64U);   // by which it is found when it moves
    EXPECT_EQ(copy.otherViews[0].view->cameraOverride, loadedFrom(phantomPath(3)).cameraOverride);
    EXPECT_FALSE(copy.otherViews[0].view->tree);
}

TEST(CaseViews, KeepTheirOwnEditedCurvesInOneFileHoweverOftenTheyAreSaved)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    core::RegistrationCase values = withCurves(twoViews());
    const core::RegistrationCase other = withCurves(*values.otherViews[0].view);
    values.otherViews[0].view = std::make_shared<const core::RegistrationCase>(other);
    for (int time = 0; time < 3; ++time) {
        ASSERT_TRUE(io::saveCase(values, folder.file("both.angiopose")));
    }
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(folder.file(""))) {
        files.push_back(entry.path().filename().string());
    }
    std::ranges::sort(files);
    EXPECT_EQ(files, (std::vector<std::string>{"both.angiopose", "both.curves.csv", "both.view-2.curves.csv"}));
    const core::RegistrationCase copy = loadedFrom(folder.file("both.angiopose"));
    ASSERT_TRUE(copy.otherViews[0].view->givenTarget);
    EXPECT_EQ(copy.otherViews[0].view->givenTarget->curves.size(), 1U);
    EXPECT_EQ(copy.otherViews[0].view->editedFrame, other.frame);
}

TEST(CaseViews, ThatCannotBeReadAreAWarningAndAreNotLost)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    core::RegistrationCase values = twoViews();
    core::RegistrationCase other = *values.otherViews[0].view;
    const std::string image = folder.file("moving.dcm");
    fs::copy_file(other.imageFile.path, image);
    other.imageFile.path = image;
    values.otherViews[0].view = std::make_shared<const core::RegistrationCase>(other);
    ASSERT_TRUE(io::saveCase(values, folder.file("both.angiopose")));
    fs::rename(image, folder.file("moved.dcm"));

    const auto missing = io::missingInputs(folder.file("both.angiopose"));
    ASSERT_TRUE(missing);
    ASSERT_EQ(missing.value().size(), 1U);
    EXPECT_TRUE(missing.value()[0].isOptional);

    core::Messages warnings;
    core::RegistrationCase without = loadedFrom(folder.file("both.angiopose"), warnings);
    ASSERT_FALSE(warnings.empty());
    EXPECT_NE(warnings.back().text().find("moving.dcm"), std::string::npos) << warnings.back();
    EXPECT_FALSE(without.otherViews[0].view->angiogram);
    ASSERT_TRUE(io::saveCase(without, folder.file("again.angiopose")));

    const auto found =
        io::findMovedInputs(io::missingInputs(folder.file("again.angiopose")).value(), {folder.file("")});
    warnings.clear();
    const auto again = io::loadCase(folder.file("again.angiopose"), warnings, {}, found);
    ASSERT_TRUE(again) << again.error().message;
    ASSERT_TRUE(again.value().otherViews[0].view->angiogram);
    EXPECT_EQ(again.value().otherViews[0].view->cameraFromPatient.matrix(), other.cameraFromPatient.matrix());
}

TEST(CaseViews, AreCheckedBeforeTheCaseIsWrittenOverThem)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    const std::string other = folder.file("other.angiopose");
    ASSERT_TRUE(io::saveCase(loadedFrom(phantomPath(3)), other));
    core::RegistrationCase values = loadedFrom(phantomPath(4));
    values.otherViews = {{{other, ""}, nullptr}};
    const auto written = io::saveCase(values, other);
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().message.text().find("will not be overwritten"), std::string::npos)
        << written.error().message;
}

}   // namespace
