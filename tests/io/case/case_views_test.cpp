#include "tests/io/case/small_case.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using test::loadedFrom;

std::string phantomPath(int view)
{
    return test::dataFile("coronary-phantom-xa/cases/IM" + std::to_string(view) + ".angiopose").string();
}

core::Case loadedFrom(const std::string& path)
{
    core::Messages warnings;
    return loadedFrom(path, warnings);
}

/// IM4 with IM3 as a second view stored in the case.
core::Case twoViews()
{
    core::Case values = test::phantomCase(4);
    core::View other = test::phantomCase(3).shown();
    other.frame = 2;
    other.cameraFromPatient.translation.x() = 1.0 / 3.0;
    other.traceOptions.sensitivity = 1.1;
    values.views.push_back(std::move(other));
    return values;
}

void addCurves(core::View& view)
{
    view.target.centerline = std::make_shared<const core::Centerline2d>(
        core::Centerline2d{{core::Curve2d{4, {{1.5, 2.5}, {7.0, 9.0}}, {1.5, 2.0}}}});
    view.target.editedFrame = view.frame;
}

TEST(CaseViews, KeepTheirOrderWhicheverIsShown)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    core::Case values = twoViews();
    values.views.push_back({});   // an empty view, which is not saved
    std::rotate(values.views.begin(), values.views.begin() + 2, values.views.end());   // blank, IM4, IM3
    for (const std::size_t shown : {1, 2}) {
        values.shownView = shown;
        ASSERT_TRUE(io::saveCase(values, folder.file("both.angiopose")));
        const core::Case copy = loadedFrom(folder.file("both.angiopose"));
        ASSERT_EQ(copy.views.size(), 2U);
        EXPECT_EQ(copy.shownView, shown - 1);
        for (const std::size_t k : {0, 1}) {
            EXPECT_EQ(copy.views[k].imageFile.sha256, values.views[k + 1].imageFile.sha256);
            EXPECT_EQ(copy.views[k].frame, values.views[k + 1].frame);
        }
    }
    core::Case alone = test::phantomCase(4);
    ASSERT_TRUE(io::saveCase(alone, folder.file("one.angiopose")));
    EXPECT_EQ(test::readText(folder.file("one.angiopose")).find("shownPlace"), std::string::npos);
    std::string far = test::readText(folder.file("both.angiopose"));
    far.replace(far.find("\"shownPlace\": 1"), 15,
                "\"shownPlace\": 77");   // beyond the last view: the last one is used
    EXPECT_EQ(loadedFrom(folder.write("far.angiopose", far)).shownView, 1U);
}

TEST(CaseViews, StandInTheCaseToTheLastBit)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    const core::Case original = twoViews();
    ASSERT_TRUE(io::saveCase(original, folder.file("both.angiopose")));
    core::Messages warnings;
    const core::Case copy = loadedFrom(folder.file("both.angiopose"), warnings);
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    ASSERT_EQ(copy.views.size(), 2U);
    const core::View& view = copy.views[1];
    const core::View& wanted = original.views[1];
    EXPECT_TRUE(view.caseFile.path.empty());
    ASSERT_TRUE(view.angiogram);
    EXPECT_EQ(view.imageFile, wanted.imageFile);
    EXPECT_EQ(view.frame, 2);
    EXPECT_EQ(view.cameraFromPatient.matrix(), wanted.cameraFromPatient.matrix());
    EXPECT_EQ(view.initialCameraFromPatient->matrix(), wanted.initialCameraFromPatient->matrix());
    EXPECT_EQ(view.geometry.cameraOverride, wanted.geometry.cameraOverride);
    EXPECT_EQ(view.geometry.cArm.primaryAngleDeg.value, wanted.geometry.cArm.primaryAngleDeg.value);
    EXPECT_EQ(view.traceOptions, wanted.traceOptions);
    EXPECT_EQ(copy.shown().cameraFromPatient.matrix(), original.shown().cameraFromPatient.matrix());
}

TEST(CaseViews, OfACaseFileAreReadWithItsGeometryButWithTheCasesVessels)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    core::Case values = test::phantomCase(4);
    values.views.emplace_back().caseFile.path = phantomPath(3);
    ASSERT_TRUE(io::saveCase(values, folder.file("both.angiopose")));
    const core::Case copy = loadedFrom(folder.file("both.angiopose"));
    ASSERT_EQ(copy.views.size(), 2U);
    const core::View& view = copy.views[1];
    EXPECT_TRUE(fs::equivalent(view.caseFile.path, phantomPath(3)));
    ASSERT_TRUE(view.angiogram);
    EXPECT_EQ(view.caseFile.sha256.size(), 64U);   // identifies the file after it was moved
    EXPECT_EQ(view.geometry.cameraOverride, test::phantomCase(3).shown().geometry.cameraOverride);
    EXPECT_EQ(copy.vessels.file, values.vessels.file);
}

TEST(CaseViews, KeepTheirOwnEditedCurvesInOneFileHoweverOftenTheyAreSaved)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    core::Case values = twoViews();
    std::ranges::for_each(values.views, addCurves);
    for (int time = 0; time < 3; ++time) {
        ASSERT_TRUE(io::saveCase(values, folder.file("both.angiopose")));
    }
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(folder.file(""))) {
        files.push_back(entry.path().filename().string());
    }
    std::ranges::sort(files);
    EXPECT_EQ(files, (std::vector<std::string>{"both.angiopose", "both.curves.csv", "both.view-2.curves.csv"}));
    const core::Case copy = loadedFrom(folder.file("both.angiopose"));
    const core::GivenTarget& curves = copy.views[1].target;
    ASSERT_TRUE(curves.centerline);
    EXPECT_EQ(curves.centerline->curves.size(), 1U);
    EXPECT_EQ(curves.editedFrame, values.views[1].frame);
}

TEST(CaseViews, ThatCannotBeReadAreAWarningAndAreNotLost)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    core::Case values = twoViews();
    core::View& other = values.views[1];
    const std::string image = folder.file("moving.dcm");
    fs::copy_file(other.imageFile.path, image);
    other.imageFile.path = image;
    ASSERT_TRUE(io::saveCase(values, folder.file("both.angiopose")));
    fs::rename(image, folder.file("moved.dcm"));

    const auto missing = io::findMissingInputs(folder.file("both.angiopose"));
    ASSERT_TRUE(missing);
    ASSERT_EQ(missing.value().size(), 1U);
    EXPECT_TRUE(missing.value()[0].isOptional);

    core::Messages warnings;
    core::Case without = loadedFrom(folder.file("both.angiopose"), warnings);
    ASSERT_FALSE(warnings.empty());
    EXPECT_NE(warnings.back().text().find("moving.dcm"), std::string::npos) << warnings.back();
    EXPECT_FALSE(without.views[1].angiogram);
    ASSERT_TRUE(io::saveCase(without, folder.file("again.angiopose")));

    const auto found =
        io::findMovedInputs(io::findMissingInputs(folder.file("again.angiopose")).value(), {folder.file("")});
    warnings.clear();
    const auto again = io::loadCase(folder.file("again.angiopose"), warnings, {}, found);
    ASSERT_TRUE(again) << again.error().message;
    ASSERT_TRUE(again.value().views[1].angiogram);
    EXPECT_EQ(again.value().views[1].cameraFromPatient.matrix(), other.cameraFromPatient.matrix());
}

TEST(CaseViews, AreCheckedBeforeTheCaseIsWrittenOverThem)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    const std::string other = folder.file("other.angiopose");
    ASSERT_TRUE(io::saveCase(test::phantomCase(3), other));
    core::Case values = test::phantomCase(4);
    values.views.emplace_back().caseFile.path = other;
    const auto written = io::saveCase(values, other);
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().message.text().find("will not be overwritten"), std::string::npos)
        << written.error().message;
}

}   // namespace
