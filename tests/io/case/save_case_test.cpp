#include "core/case/case_views.h"
#include "io/case/case_file.h"

#include "tests/io/case/small_case.h"
#include "tests/support/german_locale.h"

#include <gtest/gtest.h>
#include <limits>

using namespace angiopose;

namespace {

using test::SmallCase;

TEST(SaveCase, RestoresEveryBit)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    core::Case original = test::phantomCase(3);
    original.title = "Größe \"π\"";
    original.vessels.auxiliaryBranchIds = {4, 5};
    original.vessels.excludedBranchIds = {11};
    original.vessels.pickedPivotInPatient = Eigen::Vector3d(1.0 / 3.0, -0.1, 612.7);
    original.shown().frame = 7;
    original.options.finalScalePx = 1.0 / 3.0 + 1.0;
    original.options.locks = {true, false, true, false, true, false};
    original.shown().traceOptions.sensitivity = 1.1;
    original.shown().geometry.cArm.rollDeg = {0.1 + 0.2, core::Origin::User, ""};
    original.shown().geometry.cArm.isocenterInPatientMm = {Eigen::Vector3d(0.1, -1.0 / 3.0, 7e5), core::Origin::Derived,
                                                           "clicked"};
    original.shown().landmarks = {{{1.0 / 3.0, -2.0, 600.5}, {10.1, 511.0 / 3.0}, "bifurcation 3 / 5", ""},
                                  {{1, 2, 3}, {4, 5}, "", ""}};
    original.views.emplace_back().caseFile.path = folder.file("other.angiopose");
    original.shown().cameraFromPatient.translation.x() = 1.0 / 3.0;
    ASSERT_TRUE(io::saveCase(original, folder.file("copy.angiopose")));

    core::Messages warnings;
    const auto copy = io::loadCase(folder.file("copy.angiopose"), warnings);
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(copy.value().title, original.title);
    EXPECT_EQ(copy.value().shown().cameraFromPatient.matrix(), original.shown().cameraFromPatient.matrix());
    EXPECT_EQ(copy.value().shown().initialCameraFromPatient->matrix(),
              original.shown().initialCameraFromPatient->matrix());
    EXPECT_EQ(copy.value().shown().landmarks, original.shown().landmarks);
    ASSERT_EQ(copy.value().views.size(), 2U);
    EXPECT_EQ(copy.value().views[1].caseFile, original.views[1].caseFile);
    EXPECT_EQ(copy.value().vessels.pickedPivotInPatient, original.vessels.pickedPivotInPatient);
    EXPECT_EQ(copy.value().shown().geometry.cArm.isocenterInPatientMm.value,
              original.shown().geometry.cArm.isocenterInPatientMm.value);
    EXPECT_EQ(copy.value().shown().geometry.cArm.isocenterInPatientMm.basis, "clicked");
    EXPECT_EQ(copy.value().vessels.auxiliaryBranchIds, original.vessels.auxiliaryBranchIds);
    EXPECT_EQ(copy.value().vessels.excludedBranchIds, original.vessels.excludedBranchIds);
    EXPECT_EQ(copy.value().shown().frame, 7);
    EXPECT_EQ(copy.value().options, original.options);
    EXPECT_EQ(copy.value().shown().traceOptions, original.shown().traceOptions);
    EXPECT_EQ(copy.value().shown().geometry.cArm.rollDeg.value, original.shown().geometry.cArm.rollDeg.value);
    EXPECT_EQ(copy.value().shown().geometry.cArm.columnSpacingMm.origin, core::Origin::Derived);
    EXPECT_EQ(copy.value().shown().geometry.cameraOverride, original.shown().geometry.cameraOverride);
    EXPECT_EQ(copy.value().vessels.file, original.vessels.file);
    EXPECT_TRUE(io::validateCase(folder.file("copy.angiopose")).value().empty());
}

TEST(SaveCase, KeepsKeysItDoesNotKnow)
{
    SmallCase small;
    nlohmann::json json = small.json();
    json["site"] = {{"name", "Kragujevac"}, {"empty", nlohmann::json::object()}};
    json["vessel"]["centerline"]["tracedBy"] = "A. B.";
    json["pose"]["history"] = {1, 2.5, nullptr};
    json["options"]["futureKnob"] = 0.1;
    json["geometry"]["tableHeightMm"] = -12.25;
    json["pose"]["landmarks"] = {{{"pointInPatientMm", {1, 2, 3}}, {"pixel", {4, 5}}, {"seenBy", "E. F."}}};
    json["snapshots"] = {{{"cameraFromPatient", json["pose"]["initial"]["cameraFromPatient"]}, {"mood", 3}}};
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded) << loaded.error().message;
    ASSERT_TRUE(io::saveCase(loaded.value(), small.path("saved.angiopose")));
    const nlohmann::json saved = nlohmann::json::parse(test::readText(small.path("saved.angiopose")));
    EXPECT_EQ(saved["site"], json["site"]);
    EXPECT_EQ(saved["vessel"]["centerline"]["tracedBy"], "A. B.");
    EXPECT_EQ(saved["vessel"]["centerline"]["path"], "in/tree.csv");
    EXPECT_EQ(saved["pose"]["history"], json["pose"]["history"]);
    EXPECT_EQ(saved["options"]["futureKnob"], 0.1);
    EXPECT_EQ(saved["geometry"]["tableHeightMm"], -12.25);
    EXPECT_EQ(saved["pose"]["landmarks"][0]["seenBy"], "E. F.");
    EXPECT_EQ(saved["snapshots"][0]["mood"], 3);
    const auto again = io::loadCase(small.path("saved.angiopose"), small.warnings);
    ASSERT_TRUE(again);
    EXPECT_EQ(nlohmann::json::parse(again.value().extraKeys), nlohmann::json::parse(loaded.value().extraKeys));
    EXPECT_EQ(again.value().shown().extraKeys, loaded.value().shown().extraKeys);
}

TEST(SaveCase, KeepsKeysOfOtherViewsWithTheView)
{
    SmallCase small;
    nlohmann::json json = small.json();
    nlohmann::json view{{"angiogram", json["angiogram"]}, {"geometry", json["geometry"]}, {"pose", json["pose"]}};
    view["operator"] = "C. D.";
    view["geometry"]["tableHeightMm"] = -99.5;
    view["angiogram"]["image"]["plane"] = "B";
    json["geometry"]["tableHeightMm"] = -12.25;
    json["site"] = "Kragujevac";
    json["views"] = {view};
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded) << loaded.error().message;
    const auto saved = [&small](const core::Case& values) {
        EXPECT_TRUE(io::saveCase(values, small.path("saved.angiopose")));
        return nlohmann::json::parse(test::readText(small.path("saved.angiopose")));
    };
    const nlohmann::json same = saved(loaded.value());
    EXPECT_EQ(same["site"], "Kragujevac");
    EXPECT_EQ(same["geometry"]["tableHeightMm"], -12.25);
    ASSERT_EQ(same["views"].size(), 1U);
    EXPECT_EQ(same["views"][0]["operator"], "C. D.");
    EXPECT_EQ(same["views"][0]["geometry"]["tableHeightMm"], -99.5);
    EXPECT_EQ(same["views"][0]["angiogram"]["image"]["plane"], "B");
    // Unknown keys move with their view.
    const nlohmann::json swapped = saved(core::withShownView(loaded.value(), 1));
    EXPECT_EQ(swapped["site"], "Kragujevac");
    EXPECT_EQ(swapped["geometry"]["tableHeightMm"], -99.5);
    EXPECT_EQ(swapped["views"][0]["geometry"]["tableHeightMm"], -12.25);
}

TEST(SaveCase, NeverOverwritesAnInput)
{
    SmallCase small;
    const auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded);
    const std::string before = test::readText(small.path("in/tree.csv"));
    std::filesystem::create_symlink(small.path("in/tree.csv"), small.path("link.angiopose"));
    EXPECT_FALSE(io::saveCase(loaded.value(), small.path("in/tree.csv")));
    EXPECT_FALSE(io::saveCase(loaded.value(), small.path("link.angiopose")));
    EXPECT_EQ(test::readText(small.path("in/tree.csv")), before);
}

TEST(SaveCase, LeavesTheOldFileWhenItCannotWrite)
{
    SmallCase small;
    auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded);
    ASSERT_TRUE(io::saveCase(loaded.value(), small.path("saved.angiopose")));
    const std::string before = test::readText(small.path("saved.angiopose"));
    core::Case broken = loaded.value();
    broken.shown().cameraFromPatient.translation.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(io::saveCase(broken, small.path("saved.angiopose")));
    EXPECT_EQ(test::readText(small.path("saved.angiopose")), before);
    EXPECT_FALSE(io::saveCase(loaded.value(), small.path("absent/folder/saved.angiopose")));
    for (const auto& entry : std::filesystem::directory_iterator(small.path(""))) {
        EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << "temporary file left behind";
    }
}

TEST(SaveCase, WritesDecimalPointsInAnyLocale)
{
    SmallCase small;
    auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded);
    core::Case values = loaded.value();
    values.shown().geometry.cArm.rollDeg = {1.0 / 3.0, core::Origin::User, ""};
    const test::GermanLocale german;
    if (!german.isSet()) {
        GTEST_SKIP() << "locale de_DE.UTF-8 is neither installed nor can it be made (package locales)";
    }
    const bool saved = static_cast<bool>(io::saveCase(values, small.path("saved.angiopose")));
    const auto again = io::loadCase(small.path("saved.angiopose"), small.warnings);
    ASSERT_TRUE(saved);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again.value().shown().geometry.cArm.rollDeg.value, 1.0 / 3.0);
    EXPECT_TRUE(test::contains(test::readText(small.path("saved.angiopose")), "0.3333333333333333"));
}

}   // namespace
