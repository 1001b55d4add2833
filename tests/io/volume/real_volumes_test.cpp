#include "io/volume_file.h"

#include "tests/io/volume/volume_bytes.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using test::expectRefused;
using test::readBack;

TEST(RealVolumes, LieWhereTheirHeadersSay)
{
    ANGIOPOSE_NEEDS_DATA("thoracic-aorta-cta");
    const auto cta = io::readVolume(test::dataFile("thoracic-aorta-cta/ct_cropped.nii.gz").string());
    ASSERT_TRUE(cta) << cta.error().message;
    const core::VolumeGeometry& geometry = cta.value().volume.geometry;
    EXPECT_EQ(geometry.size, Eigen::Vector3i(120, 126, 164));
    EXPECT_LT((geometry.spacingMm - Eigen::Vector3d::Constant(1.5)).norm(), 1e-4);
    // PROVENANCE: stored right to left and front to back from (71.66, 255.66, 540.2) RAS.
    EXPECT_LT((geometry.originInPatient - Eigen::Vector3d(-71.66, -255.66, 540.2)).norm(), 0.01);
    EXPECT_TRUE(geometry.direction.isApprox(Eigen::Matrix3d::Identity(), 1e-6));

    const auto aorta = io::readLabels(test::dataFile("thoracic-aorta-cta/aorta.nii.gz").string());
    ASSERT_TRUE(aorta) << aorta.error().message;
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < aorta.value().voxels.size(); ++i) {
        if (aorta.value().voxels[i] != 0) {
            sum += cta.value().volume.value(i);
            ++count;
        }
    }
    EXPECT_EQ(count, 72'810U);
    EXPECT_NEAR(sum / static_cast<double>(count), 353.0, 1.0) << "HU inside the aorta, as PROVENANCE has it";
}

TEST(RealVolumes, OfOtherKindsLoadWithTheirPeculiarities)
{
    ANGIOPOSE_NEEDS_DATA("abdomen-ct");
    const auto wide = io::readVolume(test::dataFile("abdomen-ct/example_ct.nii.gz").string());
    ASSERT_TRUE(wide) << wide.error().message;
    EXPECT_EQ(wide.value().volume.geometry.size, Eigen::Vector3i(122, 101, 112));
    EXPECT_TRUE(wide.value().warnings.empty()) << "32-bit whole numbers that fit 16 bit";
    const auto labels = io::readVolume(test::dataFile("abdomen-ct/example_seg.nii.gz").string());
    ASSERT_TRUE(labels);
    EXPECT_TRUE(io::looksLikeLabels(labels.value().volume));
    EXPECT_FALSE(io::looksLikeLabels(wide.value().volume));

    ANGIOPOSE_NEEDS_DATA("abdominal-aorta-stent-ct");
    const auto stent = io::readVolume(test::dataFile("abdominal-aorta-stent-ct/stent.nrrd").string());
    ASSERT_TRUE(stent) << stent.error().message;
    EXPECT_EQ(stent.value().volume.geometry.size, Eigen::Vector3i(128, 128, 256));
    EXPECT_EQ(stent.value().warnings.size(), 3U) << "orientation, voxel size, rounding";
}

TEST(RealVolumes, PynrrdVariantsHoldTheSameBall)
{
    ANGIOPOSE_NEEDS_DATA("exotic-nrrd");
    const core::Volume ball = readBack(test::dataFile("exotic-nrrd/BallBinary30x30x30.nrrd").string());
    for (const char* name :
         {"BallBinary30x30x30.nhdr", "BallBinary30x30x30_gz.nrrd", "BallBinary30x30x30_byteskip_minus_one.nhdr",
          "BallBinary30x30x30_gz_byteskip_minus_one.nrrd", "BallBinary30x30x30_gz_lineskip.nrrd",
          "BallBinary30x30x30_byteskip_minus_one_nifti.nhdr"}) {
        EXPECT_EQ(readBack(test::dataFile(std::string("exotic-nrrd/") + name).string()).voxels, ball.voxels) << name;
    }
    expectRefused(test::dataFile("exotic-nrrd/BallBinary30x30x30_bz2.nrrd").string(), "bzip2");
    expectRefused(test::dataFile("exotic-nrrd/BallBinary30x30x30_byteskip_minus_five.nhdr").string(), "byte skip");
}

}   // namespace
