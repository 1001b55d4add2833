#include "core/tracing/volume/trace_vessels.h"
#include "io/volume_file.h"
#include "tests/io/case/small_case.h"
#include "tests/support/forked_vessel.h"

#include <filesystem>

using namespace angiopose;

namespace {

using test::SmallCase;

std::shared_ptr<const core::VoxelMask> forkMask()
{
    const core::LabelVolume labels = test::forkLabels();
    auto mask = std::make_shared<core::VoxelMask>(labels.geometry);
    std::ranges::transform(labels.voxels, mask->voxels.begin(), [](auto label) { return label == 2 ? 1 : 0; });
    mask->at(60, 35, 90) = 1;   // outside the vessels, as a manual edit may leave it
    return mask;
}

/// A case whose vessels were traced from a mask edited in the window.
core::Case withEditedMask(SmallCase& small)
{
    core::Case edited = small.load(small.json()).value();
    core::Vessels& vessels = edited.vessels;
    vessels.file = {};
    vessels.input = {};
    vessels.input.kind = core::VesselInputKind::Segmentation;
    vessels.input.tracing.minBranchLengthMm = 6.0;
    vessels.lumen = forkMask();
    vessels.isLumenEdited = true;
    vessels.tree =
        std::make_shared<const core::VesselTree>(core::traceMask(*vessels.lumen, vessels.input.tracing).value().tree);
    return edited;
}

TEST(CaseMask, IsKeptBesideTheCaseAndGivesTheSameVessels)
{
    SmallCase small;
    const core::Case edited = withEditedMask(small);
    EXPECT_FALSE(io::findSaveObstacle(edited));
    ASSERT_TRUE(io::saveCase(edited, small.path("saved.angiopose")));
    EXPECT_TRUE(io::validateCase(small.path("saved.angiopose")).value().empty());
    const auto json = nlohmann::json::parse(test::readText(small.path("saved.angiopose")));
    EXPECT_EQ(json["vessel"]["segmentation"]["path"], "saved.mask.nrrd");
    EXPECT_EQ(json["vessel"]["segmentation"]["origin"], "edited");
    const auto labels = io::readLabels(small.path("saved.mask.nrrd"));
    ASSERT_TRUE(labels);
    for (std::size_t voxel = 0; voxel < labels.value().voxels.size(); ++voxel) {
        ASSERT_EQ(labels.value().voxels[voxel], edited.vessels.lumen->voxels[voxel]);
    }

    const auto again = io::loadCase(small.path("saved.angiopose"), small.warnings);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_TRUE(again.value().vessels.isLumenEdited);
    const core::VesselTree& tree = *again.value().vessels.tree;
    ASSERT_EQ(tree.branches.size(), edited.vessels.tree->branches.size());
    for (std::size_t b = 0; b < tree.branches.size(); ++b) {
        EXPECT_EQ(tree.branches[b].pointsInPatient, edited.vessels.tree->branches[b].pointsInPatient);
    }
}

TEST(CaseMask, OfTheSameCaseIsReplacedAndNoOther)
{
    SmallCase small;
    core::Case edited = withEditedMask(small);
    small.folder().write("saved.mask.nrrd", "somebody else's");
    ASSERT_TRUE(io::saveCase(edited, small.path("saved.angiopose")));
    EXPECT_EQ(test::readText(small.path("saved.mask.nrrd")), "somebody else's");
    ASSERT_TRUE(std::filesystem::exists(small.path("saved.mask-2.nrrd")));

    auto less = std::make_shared<core::VoxelMask>(*edited.vessels.lumen);
    less->at(60, 35, 90) = 0;
    edited.vessels.lumen = less;
    ASSERT_TRUE(io::saveCase(edited, small.path("saved.angiopose")));
    EXPECT_FALSE(std::filesystem::exists(small.path("saved.mask-3.nrrd")));
    EXPECT_EQ(io::readLabels(small.path("saved.mask-2.nrrd")).value().at(60, 35, 90), 0);

    const auto again = io::loadCase(small.path("saved.angiopose"), small.warnings);
    ASSERT_TRUE(again) << again.error().message;
    ASSERT_TRUE(io::saveCase(again.value(), small.path("saved.angiopose")));
    EXPECT_FALSE(std::filesystem::exists(small.path("saved.mask-3.nrrd"))) << "it is there already";
    ASSERT_TRUE(io::saveCase(again.value(), small.path("other.angiopose")));
    EXPECT_TRUE(std::filesystem::exists(small.path("other.mask.nrrd"))) << "each case has its own";
}

TEST(CaseMask, AfterUndoTheMaskOfThenIsSavedAgain)
{
    SmallCase small;
    ASSERT_TRUE(io::saveCase(withEditedMask(small), small.path("saved.angiopose")));
    const core::Case first = io::loadCase(small.path("saved.angiopose"), small.warnings).value();
    core::Case second = first;
    auto less = std::make_shared<core::VoxelMask>(*first.vessels.lumen);
    less->at(60, 35, 90) = 0;
    second.vessels.lumen = less;
    second.vessels.file = {};
    ASSERT_TRUE(io::saveCase(second, small.path("saved.angiopose")));
    ASSERT_TRUE(io::saveCase(first, small.path("saved.angiopose")));   // undone in the window, which keeps its path
    small.warnings.clear();
    const auto again = io::loadCase(small.path("saved.angiopose"), small.warnings);
    ASSERT_TRUE(again);
    EXPECT_EQ(again.value().vessels.lumen->voxels, first.vessels.lumen->voxels);
    for (const core::Message& warning : small.warnings) {
        EXPECT_EQ(warning.text().find("mask"), std::string::npos) << warning.text();
    }
}

TEST(CaseMask, IsReadBesideATreeThatWasEditedAndGoesAlong)
{
    SmallCase small;
    core::Case edited = withEditedMask(small);
    auto tree = std::make_shared<core::VesselTree>(*edited.vessels.tree);
    tree->branches.front().name = "LAD";
    edited.vessels.tree = tree;
    edited.vessels.isTreeEdited = true;
    ASSERT_TRUE(io::saveCase(edited, small.path("saved.angiopose")));
    const auto again = io::loadCase(small.path("saved.angiopose"), small.warnings);
    ASSERT_TRUE(again) << again.error().message;
    ASSERT_TRUE(again.value().vessels.lumen) << "or the next save would lose it";
    EXPECT_EQ(again.value().vessels.lumen->voxels, edited.vessels.lumen->voxels);
    EXPECT_EQ(again.value().vessels.tree->branches.front().name, "LAD");

    core::Case unread = again.value();
    unread.vessels.lumen.reset();   // as if the mask could not be read
    ASSERT_TRUE(io::saveCase(unread, small.path("other.angiopose")));
    const auto labels = io::readLabels(small.path("other.mask.nrrd"));
    ASSERT_TRUE(labels) << "a copy of its own";
    EXPECT_EQ(labels.value().at(60, 35, 90), 1);
}

}   // namespace
