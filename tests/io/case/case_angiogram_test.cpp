#include "io/case/case_file.h"

#include "io/edited_curves.h"
#include "tests/io/case/small_case.h"

#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>

using namespace angiopose;

namespace {

using test::phantomCase;
using test::TemporaryFolder;

core::Case withEditedCurves(core::Case values)
{
    const core::Curve2d curve{4, {{1.0 / 3.0, 2.5}, {7.0, 9.0}, {11.25, 1e-3}}, {1.5, 2.0, 0.1}};
    values.shown().target.centerline = std::make_shared<core::Centerline2d>(core::Centerline2d{{curve}});
    values.shown().target.editedFrame = values.shown().frame;
    values.shown().target.acceptedCurveIds = {4};
    return values;
}

core::Case reloaded(const std::string& path)
{
    core::Messages warnings;
    auto loaded = io::loadCase(path, warnings);
    EXPECT_TRUE(loaded) << loaded.error().message;
    EXPECT_TRUE(loaded && io::validateCase(path).value().empty());
    return loaded ? std::move(loaded).value() : core::Case{};
}

bool hasFile(const TemporaryFolder& folder, const std::string& name)
{
    return std::filesystem::exists(folder.file(name));
}

TEST(SaveCase, KeepsEditedCurvesBesideTheCase)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const TemporaryFolder folder;
    const core::Case original = withEditedCurves(phantomCase(3));
    ASSERT_TRUE(io::saveCase(original, folder.file("a.angiopose")));
    const core::Case copy = reloaded(folder.file("a.angiopose"));
    EXPECT_EQ(copy.shown().target.file.path, folder.file("a.curves.csv"));
    ASSERT_TRUE(copy.shown().target.centerline);
    EXPECT_EQ(copy.shown().target.centerline->curves.front().id, 4);
    EXPECT_EQ(copy.shown().target.centerline->curves.front().pointsPx,
              original.shown().target.centerline->curves.front().pointsPx);
    EXPECT_EQ(copy.shown().target.centerline->curves.front().radiusPx,
              original.shown().target.centerline->curves.front().radiusPx);
    EXPECT_EQ(copy.shown().target.editedFrame, original.shown().frame);
    EXPECT_EQ(copy.shown().target.acceptedCurveIds, std::vector<int>{4});
    EXPECT_EQ(core::targetOf(copy.shown()).value().pointCount(), 3U) << "what the command line registers";

    core::Case elsewhere = copy;
    elsewhere.shown().frame = copy.shown().frame + 1;
    EXPECT_FALSE(core::givenTargetOf(elsewhere.shown())) << "curves of one frame do not stand for another";
}

TEST(SaveCase, EditedCurvesReplaceTheirOwnFileOnly)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const TemporaryFolder folder;
    std::ofstream(folder.file("a.curves.csv")) << "of somebody else";
    const core::Case original = withEditedCurves(phantomCase(3));
    ASSERT_TRUE(io::saveCase(original, folder.file("a.angiopose")));
    ASSERT_TRUE(io::saveCase(original, folder.file("a.angiopose")));
    EXPECT_TRUE(hasFile(folder, "a.curves-2.csv"));
    EXPECT_FALSE(hasFile(folder, "a.curves-3.csv"));
    std::string kept;
    std::getline(std::ifstream(folder.file("a.curves.csv")), kept);
    EXPECT_EQ(kept, "of somebody else");

    // Saving under another name copies the curves as well.
    ASSERT_TRUE(io::saveCase(reloaded(folder.file("a.angiopose")), folder.file("b.angiopose")));
    EXPECT_EQ(reloaded(folder.file("b.angiopose")).shown().target.file.path, folder.file("b.curves.csv"));
}

TEST(SaveCase, KeepsCathetersApartFromTheVessels)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const TemporaryFolder folder;
    core::Case original = withEditedCurves(phantomCase(3));
    const core::Curve2d wire{9, {{20.0, 20.0}, {40.0, 41.0}}, {1.0, 1.0}};
    original.shown().target.devices = std::make_shared<core::Centerline2d>(core::Centerline2d{{wire}});
    ASSERT_TRUE(io::saveCase(original, folder.file("a.angiopose")));
    core::Case copy = reloaded(folder.file("a.angiopose"));
    ASSERT_TRUE(core::devicesOf(copy.shown()));
    EXPECT_EQ(core::curveIds(*core::devicesOf(copy.shown())), std::vector<int>{9});
    EXPECT_EQ(core::devicesOf(copy.shown())->curves.front().pointsPx, wire.pointsPx);
    EXPECT_EQ(core::curveIds(core::targetOf(copy.shown(), "angiopose").value()), std::vector<int>{4});
    EXPECT_EQ(core::curveIds(core::targetOf(copy.shown(), "wire").value()), std::vector<int>{9});
    EXPECT_EQ(io::exportedFile(copy.shown().target).sha256, io::exportedFile(original.shown().target).sha256);
    copy.shown().frame += 1;
    EXPECT_FALSE(core::devicesOf(copy.shown())) << "of one frame";
}

TEST(SaveCase, RestoresTheSubtraction)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const TemporaryFolder folder;
    core::Case original = phantomCase(4);
    original.shown().processing.isSubtracted = true;
    original.shown().processing.plan.maskFrames = {0, 1};
    original.shown().processing.plan.maskShiftPx = Eigen::Vector2d(0.25, -1.0 / 3.0);
    original.shown().processing.plan.relation = core::PixelRelation::Logarithmic;
    const auto treated = core::processRun(*original.shown().angiogram, original.shown().processing);
    ASSERT_TRUE(treated) << treated.error().message;
    original.shown().storedRun = original.shown().angiogram;
    original.shown().angiogram = std::make_shared<core::Angiogram>(treated.value());
    ASSERT_TRUE(io::saveCase(original, folder.file("dsa.angiopose")));

    const core::Case copy = reloaded(folder.file("dsa.angiopose"));
    EXPECT_EQ(copy.shown().processing, original.shown().processing);
    ASSERT_TRUE(copy.shown().storedRun);
    EXPECT_EQ(copy.shown().storedRun->frames[4].pixels, original.shown().storedRun->frames[4].pixels);
    EXPECT_EQ(copy.shown().angiogram->frames[4].pixels, original.shown().angiogram->frames[4].pixels);
    EXPECT_NE(copy.shown().angiogram->frames[4].pixels, copy.shown().storedRun->frames[4].pixels);
}

TEST(LoadCase, SubtractionThatCannotBeIsRefused)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const TemporaryFolder folder;
    core::Case original = phantomCase(4);
    original.shown().processing.isSubtracted = true;
    original.shown().processing.plan.maskFrames = {99};
    ASSERT_TRUE(io::saveCase(original, folder.file("dsa.angiopose")));
    core::Messages warnings;
    const auto loaded = io::loadCase(folder.file("dsa.angiopose"), warnings);
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error().message.text().find("Mask frame 100"), std::string::npos) << loaded.error().message;
}

}   // namespace
