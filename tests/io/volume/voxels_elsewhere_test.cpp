#include "io/volume_file.h"
#include "tests/support/forked_vessel.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

using namespace angiopose;

// Headers whose voxels are stored in another file.

namespace {

using test::TemporaryFolder;

std::string detachedHeader(const std::string& voxels, const std::string& skip)
{
    return "NRRD0004\ntype: uint16\ndimension: 3\nspace: left-posterior-superior\nsizes: 64 40 96\n" + skip +
           "space directions: (1,0,0) (0,1,0) (0,0,1)\nendian: little\nencoding: raw\nspace origin: (-32,-18,-6)\n"
           "data file: " +
           voxels + "\n";
}

TEST(VoxelsElsewhere, OfAWholeVolumeAreRefusedUntilItsHeaderIsSkipped)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(io::writeLabels(test::forkLabels(), folder.file("fork.nii")));
    const std::string shifted = folder.write("shifted.nhdr", detachedHeader("fork.nii", ""));
    const auto refused = io::readLabels(shifted);
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().message.text().starts_with(shifted)) << refused.error().message;
    EXPECT_NE(refused.error().message.text().find("header of another volume"), std::string::npos)
        << refused.error().message;
    EXPECT_FALSE(io::describeVolume(shifted));

    const std::string skipping = folder.write("skipping.nhdr", detachedHeader("fork.nii", "byte skip: -1\n"));
    const auto read = io::readLabels(skipping);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read.value().voxels, test::forkLabels().voxels);
}

TEST(VoxelsElsewhere, AreNamedWhereTheyAreMissing)
{
    const TemporaryFolder folder;
    const std::string header = folder.write("scan.nhdr", detachedHeader("scan.raw", ""));
    const auto refused = io::readVolume(header);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message.text(),
              header + ": the voxel data file scan.raw is missing. Copy both files together.");
}

}   // namespace
