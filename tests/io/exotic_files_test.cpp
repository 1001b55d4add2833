#include "io/angiogram_file.h"
#include "io/case/case_file.h"
#include "io/centerline2d_file.h"
#include "io/pose_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <algorithm>

using namespace angiopose;

// Unusual, malformed and truncated files of other projects, and files of the wrong kind: each reader loads what is
// valid or reports in one message which file, what is wrong and what to do.

namespace {

std::vector<std::string> filesBelow(const std::string& folder)
{
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::dataFile(folder))) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path().string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

void expectClearMessage(const core::Error& error, const std::string& path)
{
    EXPECT_TRUE(error.message.text().starts_with(path + ": ")) << error.message;
    EXPECT_TRUE(error.message.text().ends_with(".")) << error.message;
    EXPECT_LT(error.message.text().size(), path.size() + 400) << error.message;
    EXPECT_EQ(error.message.text().find('\n'), std::string::npos) << error.message;
}

void readWithEveryReader(const std::string& path)
{
    SCOPED_TRACE(path);
    if (const auto tree = io::readVesselTree(path); !tree) {
        expectClearMessage(tree.error(), path);
    } else {
        EXPECT_FALSE(core::findProblem(tree.value()));
    }
    if (const auto angiogram = io::readAngiogram(path); !angiogram) {
        expectClearMessage(angiogram.error(), path);
    } else {
        EXPECT_GT(angiogram.value().frameCount(), 0);
        EXPECT_LT(angiogram.value().suggestedFrame, angiogram.value().frameCount());
    }
    if (const auto target = io::readCenterline2d(path); !target) {
        expectClearMessage(target.error(), path);
    }
    if (const auto pose = io::readPose(path); !pose) {
        expectClearMessage(pose.error(), path);
    }
    if (const auto volume = io::readVolume(path); !volume) {
        EXPECT_NE(volume.error().message.text().find(": "), std::string::npos) << volume.error().message;
        EXPECT_TRUE(volume.error().message.text().ends_with(".")) << volume.error().message;
    } else {
        EXPECT_EQ(volume.value().volume.voxels.size(), volume.value().volume.geometry.voxelCount());
    }
    if (const auto labels = io::readLabels(path); !labels) {
        EXPECT_TRUE(labels.error().message.text().ends_with(".")) << labels.error().message;
    }
    core::Messages warnings;
    const auto loaded = io::loadCase(path, warnings);
    ASSERT_FALSE(loaded);
    expectClearMessage(loaded.error(), path);
    EXPECT_TRUE(!io::validateCase(path) || !io::validateCase(path).value().empty());
}

class ExoticFiles : public ::testing::TestWithParam<const char*> {};

}   // namespace

TEST_P(ExoticFiles, LoadOrExplainThemselves)
{
    ANGIOPOSE_NEEDS_DATA(GetParam());
    for (const std::string& path : filesBelow(GetParam())) {
        readWithEveryReader(path);
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    EXPECT_LT(usage.ru_maxrss, 1L << 20) << "kilobytes at most";
}

TEST(LfsPointers, AreNamedAsWhatTheyAre)
{
    ANGIOPOSE_NEEDS_DATA("exotic-lfs-pointers");
    for (const char* name : {"cow.vtp", "cow.vtk", "IM-0001-1983.dcm", "HeadMRVolume.mhd"}) {
        const std::string path = test::dataFile(std::string("exotic-lfs-pointers/") + name).string();
        const auto tree = io::readVesselTree(path);
        ASSERT_FALSE(tree);
        EXPECT_NE(tree.error().message.text().find("git lfs pull"), std::string::npos);
        const auto angiogram = io::readAngiogram(path);
        ASSERT_FALSE(angiogram);
        EXPECT_NE(angiogram.error().message.text().find("git lfs pull"), std::string::npos);
    }
}

INSTANTIATE_TEST_SUITE_P(Folders, ExoticFiles,
                         ::testing::Values("exotic-dicom", "exotic-lfs-pointers", "exotic-mesh", "exotic-nifti",
                                           "exotic-nrrd", "abdominal-aorta-mesh", "cerebral-artery-graphs"));
