#include "io/case/case_file.h"

#include "io/file_hash.h"
#include "io/volume_file.h"
#include "tests/io/case/small_case.h"
#include "tests/support/forked_vessel.h"

#include <gtest/gtest.h>
#include <filesystem>

using namespace angiopose;

namespace {

using test::anyContains;
using test::contains;
using test::SmallCase;

/// The tree of the small case with its second branch renamed and a point moved by a fractional amount.
std::shared_ptr<const core::VesselTree> editedTree(const core::Case& values)
{
    core::VesselTree tree = *values.vessels.tree;
    tree.branches[1].name = "Äste \"2\"";
    tree.branches[1].generation = 1;
    tree.branches[1].pointsInPatient[1].y() += 1.0 / 3.0;
    tree.branches[1].radiusMm = {1.1, 0.1 + 0.2};
    return std::make_shared<const core::VesselTree>(std::move(tree));
}

TEST(LoadCase, TracesASegmentationWithTheParametersBesideIt)
{
    SmallCase small;
    ASSERT_TRUE(io::writeLabels(test::forkLabels(), small.path("in/mask.nii.gz")));
    nlohmann::json json = small.json();
    json["vessel"] = {{"segmentation", {{"path", "in/mask.nii.gz"}}},
                      {"labels", {2}},
                      {"surface", {{"path", "other.stl"}, {"note", "kept"}}},
                      {"tracing", {{"minBranchLengthMm", 7.5}, {"rootInPatientMm", {0, 0, 0}}, {"mine", true}}}};

    const auto loaded = small.load(json);

    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(test::endsOf(*loaded.value().vessels.tree), 3);
    for (const core::VesselBranch& branch : loaded.value().vessels.tree->branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            EXPECT_LT(test::distanceToFork(point), 1.5);
        }
    }
    ASSERT_TRUE(io::saveCase(loaded.value(), small.path("copy.angiopose")));
    core::Messages warnings;
    const auto copy = io::loadCase(small.path("copy.angiopose"), warnings);
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(copy.value().vessels.input, loaded.value().vessels.input);
    EXPECT_EQ(copy.value().vessels.input.tracing.minBranchLengthMm, 7.5);
    EXPECT_EQ(copy.value().vessels.file, loaded.value().vessels.file);
    EXPECT_EQ(copy.value().vessels.tree->branches.front().pointsInPatient,
              loaded.value().vessels.tree->branches.front().pointsInPatient);
    const auto saved = nlohmann::json::parse(test::readText(small.path("copy.angiopose")));
    EXPECT_EQ(saved["vessel"]["surface"]["note"], "kept") << "another kind beside it survives";
    EXPECT_EQ(saved["vessel"]["tracing"]["mine"], true);
    EXPECT_TRUE(io::validateCase(small.path("copy.angiopose")).value().empty());
}

TEST(SaveCase, KeepsAnEditedTreeToTheLastBit)
{
    SmallCase small;
    core::Case edited = small.load(small.json()).value();
    edited.vessels.tree = editedTree(edited);
    edited.vessels.isTreeEdited = true;
    edited.vessels.hiddenBranchIds = {2};
    const std::string input = small.path("in/tree.csv");
    const auto before = io::sha256OfFile(input).value();
    ASSERT_TRUE(io::saveCase(edited, small.path("edited.angiopose")));

    EXPECT_EQ(io::sha256OfFile(input).value(), before);
    EXPECT_TRUE(io::validateCase(small.path("edited.angiopose")).value().empty());
    core::Messages warnings;
    const auto copy = io::loadCase(small.path("edited.angiopose"), warnings);
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(warnings, small.warnings);   // those of the image, none about the tree
    EXPECT_TRUE(copy.value().vessels.isTreeEdited);
    EXPECT_EQ(copy.value().vessels.hiddenBranchIds, std::vector{2});
    ASSERT_EQ(copy.value().vessels.tree->branches.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        const core::VesselBranch& a = edited.vessels.tree->branches[i];
        const core::VesselBranch& b = copy.value().vessels.tree->branches[i];
        EXPECT_EQ(a.id, b.id);
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.generation, b.generation);
        EXPECT_EQ(a.pointsInPatient, b.pointsInPatient);
        EXPECT_EQ(a.radiusMm, b.radiusMm);
    }
}

TEST(LoadCase, OpensAnEditedTreeWithoutItsOrigin)
{
    SmallCase small;
    core::Case edited = small.load(small.json()).value();
    edited.vessels.tree = editedTree(edited);
    edited.vessels.isTreeEdited = true;
    ASSERT_TRUE(io::saveCase(edited, small.path("edited.angiopose")));
    std::filesystem::remove(small.path("in/tree.csv"));

    core::Messages warnings;
    const auto copy = io::loadCase(small.path("edited.angiopose"), warnings);
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(copy.value().vessels.tree->branches[1].name, edited.vessels.tree->branches[1].name);
    EXPECT_EQ(copy.value().vessels.file.sha256, edited.vessels.file.sha256);
    EXPECT_TRUE(anyContains(warnings, "can be opened without this file"));
}

TEST(LoadCase, RefusesAnEditedTreeThatIsNone)
{
    SmallCase small;
    nlohmann::json json = small.json();
    const auto branch = nlohmann::json::parse(R"({"id": 1, "pointsMm": [[0,0,0],[0,0,1]]})");
    json["vessel"]["editedTree"]["branches"] = {branch, branch};
    EXPECT_TRUE(contains(small.errorOf(json), "branch 1 occurs twice"));
    json["vessel"]["editedTree"]["branches"] = nlohmann::json::array();
    EXPECT_TRUE(contains(small.errorOf(json), "vessel.editedTree"));
    json["vessel"]["editedTree"]["branches"] = {{{"id", 1}, {"pointsMm", {{0, 0}, {1, 1}}}}};
    EXPECT_TRUE(contains(small.errorOf(json), "vessel.editedTree"));
}

TEST(LoadCase, ReadsTheScanOfAnEditedTreeWithoutTracingIt)
{
    SmallCase small;
    ASSERT_TRUE(io::writeVolume(test::forkScan(), small.path("in/scan.nrrd")));
    nlohmann::json json = small.json();
    json["vessel"] = {{"volume", {{"path", "in/scan.nrrd"}}}};
    json["vessel"]["editedTree"]["branches"] = {{{"id", 5}, {"pointsMm", {{0, 0, 0}, {0, 0, 30}}}}};
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded) << loaded.error().message;
    ASSERT_TRUE(loaded.value().vessels.scan);
    ASSERT_EQ(loaded.value().vessels.tree->branches.size(), 1U);
    EXPECT_EQ(loaded.value().vessels.tree->branches[0].id, 5);
    EXPECT_FALSE(loaded.value().vessels.lumen);
}

TEST(LoadCase, ReadsTheScanThatOtherVesselsLieIn)
{
    SmallCase small;
    ASSERT_TRUE(io::writeVolume(test::forkScan(), small.path("in/scan.nrrd")));
    nlohmann::json json = small.json();
    json["vessel"]["volume"]["path"] = "in/scan.nrrd";
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded.value().vessels.input.kind, core::VesselInputKind::Centerline);
    EXPECT_EQ(loaded.value().vessels.tree->branches.size(), 2U);
    ASSERT_TRUE(loaded.value().vessels.scan);
    ASSERT_TRUE(io::saveCase(loaded.value(), small.path("copy.angiopose")));
    core::Messages warnings;
    EXPECT_EQ(io::loadCase(small.path("copy.angiopose"), warnings).value().vessels.scanFile,
              loaded.value().vessels.scanFile);
    EXPECT_EQ(warnings, small.warnings);   // those of the image, none about the scan

    json["vessel"]["volume"]["path"] = "in/gone.nrrd";
    const auto without = small.load(json);
    ASSERT_TRUE(without) << without.error().message;
    EXPECT_FALSE(without.value().vessels.scan);
    EXPECT_TRUE(anyContains(small.warnings, "gone.nrrd"));
}

TEST(LoadCase, StopsTracingWhenAsked)
{
    SmallCase small;
    ASSERT_TRUE(io::writeLabels(test::forkLabels(), small.path("in/mask.nii.gz")));
    nlohmann::json json = small.json();
    json["vessel"] = {{"segmentation", {{"path", "in/mask.nii.gz"}}}};
    core::Messages warnings;
    const auto stopped = io::loadCase(small.write(json), warnings, [](double) { return core::ObserverDecision::Stop; });
    ASSERT_FALSE(stopped);
    EXPECT_TRUE(stopped.isStopped());
}

}   // namespace
