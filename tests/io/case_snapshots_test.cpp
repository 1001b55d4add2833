#include "tests/io/case/small_case.h"

#include <gtest/gtest.h>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

using namespace angiopose;

namespace {

core::PoseSnapshot sampleSnapshot()
{
    core::PoseSnapshot snapshot;
    snapshot.id = 1;
    snapshot.name = "Größe, “π”";
    snapshot.author = "Ada";
    snapshot.note = "line one\nline two";
    snapshot.time = "2026-11-21T16:00:00Z";
    snapshot.method = "angiopose";
    snapshot.kind = core::SnapshotKind::Run;
    snapshot.frame = 5;
    snapshot.cameraFromPatient = {core::expSo3({0.1, 0.2, 1.0 / 3.0}), {1.0 / 3.0, -2.0, 800.0}};
    snapshot.metrics = core::SnapshotMetrics{0.71, 0.22, 0.61, 0.93, true};
    snapshot.runMs = 8.4;
    return snapshot;
}

/// Saves the phantom's case with a JSON patch applied.
std::string savedWith(const test::TemporaryFolder& folder, const core::Case& values, const nlohmann::json& patch)
{
    const std::string path = folder.file("patched.angiopose");
    EXPECT_TRUE(io::saveCase(values, path));
    std::ifstream in(path);
    nlohmann::json json = nlohmann::json::parse(in);
    json.merge_patch(patch);
    std::ofstream(path) << json.dump();
    return path;
}

TEST(CaseSnapshots, AreRestoredToTheLastBit)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    core::Messages warnings;
    core::Case original = test::phantomCase(2);
    const core::PoseSnapshot expected = sampleSnapshot();
    core::PoseSnapshot bare;
    bare.id = 2;
    bare.name = "by hand";
    original.shown().snapshots = {expected, bare};

    ASSERT_TRUE(io::saveCase(original, folder.file("kept.angiopose")));
    const auto again = io::loadCase(folder.file("kept.angiopose"), warnings);
    ASSERT_TRUE(again) << again.error().message;

    const auto& read = again.value().shown().snapshots;
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0].name, expected.name);
    EXPECT_EQ(read[0].author, expected.author);
    EXPECT_EQ(read[0].note, expected.note);
    EXPECT_EQ(read[0].time, expected.time);
    EXPECT_EQ(read[0].method, expected.method);
    EXPECT_EQ(read[0].kind, expected.kind);
    EXPECT_EQ(read[0].frame, expected.frame);
    EXPECT_EQ(read[0].metrics, expected.metrics);
    EXPECT_EQ(read[0].runMs, expected.runMs);
    EXPECT_EQ(read[0].cameraFromPatient.matrix(), expected.cameraFromPatient.matrix());
    EXPECT_EQ(read[1].kind, core::SnapshotKind::Saved);
    EXPECT_FALSE(read[1].metrics);
    EXPECT_NE(read[0].id, read[1].id);
    EXPECT_EQ(again.value().extraKeys, original.extraKeys);
}

TEST(CaseSnapshots, WithNumbersThatAreNoneAreStillReadable)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    core::Messages warnings;
    core::Case values = test::phantomCase(2);
    core::PoseSnapshot unseen = sampleSnapshot();
    unseen.metrics->medianMm = std::numeric_limits<double>::quiet_NaN();   // none of the tree is in the image
    values.shown().snapshots = {unseen};
    ASSERT_TRUE(io::saveCase(values, folder.file("nan.angiopose")));
    const auto again = io::loadCase(folder.file("nan.angiopose"), warnings);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_FALSE(again.value().shown().snapshots.front().metrics);
}

TEST(CaseSnapshots, ThatMakeNoSenseAreRefusedInWords)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::TemporaryFolder folder;
    core::Messages warnings;
    const core::Case values = test::phantomCase(2);
    const nlohmann::json zero =
        nlohmann::json::parse(R"({"snapshots": [{"cameraFromPatient": [[0,0,0,0],[0,0,0,0],[0,0,0,0],[0,0,0,1]]}]})");
    const nlohmann::json missing = nlohmann::json::parse(R"({"snapshots": [{"name": "no pose"}]})");
    for (const nlohmann::json& patch : {zero, missing}) {
        const auto broken = io::loadCase(savedWith(folder, values, patch), warnings);
        ASSERT_FALSE(broken);
        EXPECT_NE(broken.error().message.text().find("snapshots"), std::string::npos) << broken.error().message;
    }
}

}   // namespace
