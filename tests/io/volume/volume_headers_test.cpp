#include "io/volume_file.h"

#include "tests/io/volume/volume_bytes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <array>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

using namespace angiopose;

namespace {

using test::expectRefused;
using test::metaImage;
using test::readBack;
using test::TemporaryFolder;

/// A NIfTI-1 header for 2 x 3 x 4 voxels of 16 bits, without any orientation.
std::string plainNifti()
{
    std::string header(352, '\0');
    const auto put = [&](std::size_t offset, auto value) { std::memcpy(header.data() + offset, &value, sizeof value); };
    put(0, std::int32_t{348});
    const std::array<std::int16_t, 8> dim = {3, 2, 3, 4, 1, 1, 1, 1};
    const std::array<float, 8> pixdim = {1.0F, 0.5F, 2.0F, 3.0F, 0, 0, 0, 0};
    put(40, dim);
    put(76, pixdim);
    put(70, std::int16_t{4});
    put(72, std::int16_t{16});
    put(108, 352.0F);
    std::memcpy(header.data() + 344, "n+1", 4);
    return header;
}

std::string withVoxels(std::string header, std::size_t count)
{
    std::vector<std::int16_t> voxels(count);
    std::iota(voxels.begin(), voxels.end(), std::int16_t{0});
    return header + test::bytesOf(voxels);
}

template <class T>
void put(std::string& header, std::size_t offset, T value)
{
    std::memcpy(header.data() + offset, &value, sizeof value);
}

TEST(Nifti, SformWinsAndRasBecomesLps)
{
    const TemporaryFolder folder;
    std::string header = plainNifti();
    put(header, 254, std::int16_t{1});
    const std::array<float, 12> sform = {0, 2, 0, 10, -0.5F, 0, 0, 20, 0, 0, 3, 30};   // i runs to P, j to R
    put(header, 280, sform);

    const core::Volume volume = readBack(folder.write("a.nii", withVoxels(header, 24)));

    const Eigen::Affine3d map = volume.geometry.patientFromVoxel();
    EXPECT_LT((map * Eigen::Vector3d(0, 0, 0) - Eigen::Vector3d(-10, -20, 30)).norm(), 1e-5);
    EXPECT_LT((map * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(-10, -19.5, 30)).norm(), 1e-5);
    EXPECT_LT((map * Eigen::Vector3d(0, 1, 0) - Eigen::Vector3d(-12, -20, 30)).norm(), 1e-5);
    EXPECT_LT((map * Eigen::Vector3d(0, 0, 1) - Eigen::Vector3d(-10, -20, 33)).norm(), 1e-5);
}

TEST(Nifti, QformIsFollowedWithItsHandedness)
{
    const TemporaryFolder folder;
    std::string header = plainNifti();
    put(header, 252, std::int16_t{1});
    put(header, 76, -1.0F);   // k reversed
    put(header, 256, std::array<float, 6>{0, 0, 1, 5, 6, 7});   // a rotation by 180° about z

    const core::Volume volume = readBack(folder.write("a.nii", withVoxels(header, 24)));

    const Eigen::Affine3d map = volume.geometry.patientFromVoxel();
    EXPECT_LT((map * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(-4.5, -6, 7)).norm(), 1e-5);
    EXPECT_LT((map * Eigen::Vector3d(0, 1, 0) - Eigen::Vector3d(-5, -4, 7)).norm(), 1e-5);
    EXPECT_LT((map * Eigen::Vector3d(0, 0, 1) - Eigen::Vector3d(-5, -6, 4)).norm(), 1e-5);
}

TEST(Nifti, TheScannersPlacementBeatsAnAtlas)
{
    const TemporaryFolder folder;
    std::string header = plainNifti();
    put(header, 252, std::int16_t{1});
    put(header, 256, std::array<float, 6>{0, 0, 0, 5, 6, 7});
    put(header, 254, std::int16_t{4});   // MNI 152
    put(header, 280, std::array<float, 12>{1, 0, 0, 99, 0, 1, 0, 99, 0, 0, 1, 99});

    const auto loaded = io::readVolume(folder.write("a.nii", withVoxels(header, 24)));

    ASSERT_TRUE(loaded);
    EXPECT_LT((loaded.value().volume.geometry.originInPatient - Eigen::Vector3d(-5, -6, 7)).norm(), 1e-5);
    EXPECT_NE(loaded.value().warnings.front().text().find("qform"), std::string::npos);
}

TEST(Nifti, SaysWhenThePlacementIsUnknown)
{
    const TemporaryFolder folder;
    const auto loaded = io::readVolume(folder.write("a.nii", withVoxels(plainNifti(), 24)));
    ASSERT_TRUE(loaded);
    EXPECT_LT((loaded.value().volume.geometry.spacingMm - Eigen::Vector3d(0.5, 2.0, 3.0)).norm(), 1e-6);
    ASSERT_EQ(loaded.value().warnings.size(), 1U);
    EXPECT_NE(loaded.value().warnings.front().text().find("left and right"), std::string::npos);
}

TEST(Nifti, RefusesWhatIsNoVolume)
{
    const TemporaryFolder folder;
    std::string series = plainNifti();
    put(series, 40, std::array<std::int16_t, 8>{4, 2, 3, 4, 7, 1, 1, 1});
    expectRefused(folder.write("4d.nii", series), "7 volumes");

    std::string color = plainNifti();
    put(color, 70, std::int16_t{128});
    expectRefused(folder.write("rgb.nii", color), "colors");

    std::string huge = plainNifti();
    put(huge, 40, std::array<std::int16_t, 8>{3, 30000, 30000, 30000, 1, 1, 1, 1});
    expectRefused(folder.write("huge.nii", huge), "more than AngioPose supports");

    std::string lying = plainNifti();
    put(lying, 40, std::array<std::int16_t, 8>{3, 1000, 1000, 1000, 1, 1, 1, 1});
    expectRefused(folder.write("lying.nii", lying), "truncated");

    std::string sheared = plainNifti();
    put(sheared, 254, std::int16_t{1});
    put(sheared, 280, std::array<float, 12>{1, 0.2F, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
    expectRefused(folder.write("sheared.nii", withVoxels(sheared, 24)), "instead of 90");

    std::string flat = plainNifti();
    put(flat, 40, std::array<std::int16_t, 8>{2, 2, 3, 1, 1, 1, 1, 1});
    expectRefused(folder.write("flat.nii", withVoxels(flat, 6)), "single slice");
}

TEST(Nrrd, SpacesBecomeLps)
{
    const TemporaryFolder folder;
    const auto header = [](const std::string& space) {
        return "NRRD0004\ntype: short\ndimension: 3\n" + space +
               "sizes: 2 2 2\nspace directions: (0,2,0) (3,0,0) (0,0,4)\nspace origin: (10,20,30)\nendian: little\n"
               "encoding: raw\n\n";
    };
    const auto place = [&](const std::string& space) {
        const core::Volume volume = readBack(folder.write("a.nrrd", header(space) + std::string(16, '\0')));
        return Eigen::Vector3d(volume.geometry.patientFromVoxel() * Eigen::Vector3d(1, 1, 1));
    };
    EXPECT_LT((place("space: left-posterior-superior\n") - Eigen::Vector3d(13, 22, 34)).norm(), 1e-9);
    EXPECT_LT((place("space: RAS\n") - Eigen::Vector3d(-13, -22, 34)).norm(), 1e-9);
    EXPECT_LT((place("space: left-anterior-superior\n") - Eigen::Vector3d(13, -22, 34)).norm(), 1e-9);
    const auto unknown = io::readVolume(folder.write("b.nrrd", header("") + std::string(16, '\0')));
    ASSERT_TRUE(unknown);
    EXPECT_NE(unknown.value().warnings.front().text().find("left and right"), std::string::npos);
}

/// The library copies text that it cannot parse into a buffer of fixed size.
TEST(Nrrd, RefusesAFieldOfAMegabyte)
{
    const TemporaryFolder folder;
    std::string longField = "space directions: (1,0,0) (0,1,0e ";
    while (longField.size() < 900000) {
        longField += longField;
    }
    const std::string header = "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\n";
    expectRefused(
        folder.write("a.nrrd", header + longField + "\nendian: little\nencoding: raw\n\n" + std::string(16, '\0')),
        "the header cannot be read");
}

/// Free text may have any length.
TEST(Nrrd, ReadsALongComment)
{
    const TemporaryFolder folder;
    const std::string text(5000, 'x');
    const std::string header = "NRRD0004\n# " + text + "\ntype: short\ndimension: 3\nsizes: 2 2 2\ncontent: " + text +
                               "\nendian: little\nencoding: raw\nkey:=" + text + "\n\n";
    EXPECT_TRUE(io::readVolume(folder.write("a.nrrd", header + std::string(16, '\0'))));
}

TEST(MetaImage, NamesHeaderAndVoxelsWhenTheseAreMissing)
{
    const TemporaryFolder folder;
    const std::string header = metaImage("MET_SHORT", "");
    const std::string path = folder.write("scan.mhd", header.substr(0, header.find("LOCAL")) + "elsewhere.raw\n");
    expectRefused(path, "elsewhere.raw");
}

std::string nrrdInUnits(const std::string& unit, double perMm)
{
    const auto number = [perMm](double mm) { return std::to_string(mm * perMm); };
    return "NRRD0005\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\nspace directions: (" +
           number(0.7) + ",0,0) (0," + number(0.7) + ",0) (0,0," + number(1.25) + ")\nspace units: \"" + unit +
           "\" \"" + unit + "\" \"" + unit + "\"\nspace origin: (" + number(-10) + "," + number(20) + "," + number(30) +
           ")\nendian: little\nencoding: raw\n\n" + std::string(16, '\0');
}

TEST(Nrrd, UnitsHoldForDirectionsAndOrigin)
{
    const TemporaryFolder folder;
    for (const auto& [unit, perMm] :
         {std::pair{"um", 1000.0}, std::pair{"micron", 1000.0}, std::pair{"\xc2\xb5m", 1000.0}, std::pair{"cm", 0.1},
          std::pair{"Centimeters", 0.1}, std::pair{"m", 0.001}, std::pair{"mm", 1.0}, std::pair{"Millimetre", 1.0}}) {
        const auto loaded = io::readVolume(folder.write("a.nrrd", nrrdInUnits(unit, perMm)));
        ASSERT_TRUE(loaded) << unit << loaded.error().message;
        const core::VolumeGeometry& geometry = loaded.value().volume.geometry;
        EXPECT_LT((geometry.spacingMm - Eigen::Vector3d(0.7, 0.7, 1.25)).norm(), 1e-6) << unit;
        EXPECT_LT((geometry.originInPatient - Eigen::Vector3d(-10, 20, 30)).norm(), 1e-6) << unit;
        EXPECT_TRUE(loaded.value().warnings.empty()) << unit;
    }
    const auto unknown = io::readVolume(folder.write("b.nrrd", nrrdInUnits("furlong", 1.0)));
    ASSERT_TRUE(unknown);
    ASSERT_EQ(unknown.value().warnings.size(), 1U);
    EXPECT_NE(unknown.value().warnings.front().text().find("\"furlong\""), std::string::npos);
}

TEST(MetaImage, DistanceUnitsHoldForSpacingAndOffset)
{
    const TemporaryFolder folder;
    const core::VolumeGeometry geometry =
        readBack(folder.write("a.mha",
                              metaImage("MET_SHORT", std::string(16, '\0'), "DistanceUnits = cm\nOffset = 1 2 3\n")))
            .geometry;
    EXPECT_LT((geometry.spacingMm - Eigen::Vector3d(10, 10, 10)).norm(), 1e-9);
    EXPECT_LT((geometry.originInPatient - Eigen::Vector3d(10, 20, 30)).norm(), 1e-9);
}

/// Voxels starting inside the header would be header bytes.
TEST(Nifti, VoxelsBeginBehindTheHeader)
{
    const TemporaryFolder folder;
    for (const float offset : {0.0F, 348.0F, 351.0F}) {
        std::string header = plainNifti();
        put(header, 108, offset);
        const auto loaded = io::readVolume(folder.write("a.nii", withVoxels(header, 24)));
        ASSERT_TRUE(loaded) << loaded.error().message;
        EXPECT_EQ(loaded.value().volume.value(0), 0.0) << offset;
        EXPECT_EQ(loaded.value().volume.value(23), 23.0) << offset;
        EXPECT_EQ(loaded.value().warnings.back().text(),
                  "The header states that the voxel data begin at byte " + std::to_string(static_cast<int>(offset)) +
                      ", inside the header itself; they are read from byte 352 instead.");
    }
    std::string early = plainNifti();
    put(early, 108, 0.0F);
    const std::string whole = withVoxels(early, 24);
    expectRefused(folder.write("early.nii", whole.substr(0, 348) + whole.substr(352)), "truncated");
}

TEST(Nifti, SaysBothValuesWhereItsHeaderContradictsItself)
{
    const TemporaryFolder folder;
    std::string header = plainNifti();
    put(header, 72, std::int16_t{32});   // declares 32 bits for 16-bit voxels
    put(header, 254, std::int16_t{1});
    put(header, 280, std::array<float, 12>{0.7F, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0});   // 0.5 according to pixdim
    const auto loaded = io::readVolume(folder.write("a.nii", withVoxels(header, 24)));
    ASSERT_TRUE(loaded);
    ASSERT_EQ(loaded.value().warnings.size(), 2U);
    EXPECT_NE(loaded.value().warnings[0].text().find("0.5 x 2 x 3 (pixdim) and 0.7 x 2 x 3"), std::string::npos)
        << loaded.value().warnings[0];
    EXPECT_NE(loaded.value().warnings[1].text().find("32 bits (bitpix), but 16 bits"), std::string::npos)
        << loaded.value().warnings[1];
}

TEST(Volumes, WithoutASizeAreNeitherReadNorWritten)
{
    const TemporaryFolder folder;
    for (const char* size : {"0 1 1", "nan 1 1"}) {
        std::string content = metaImage("MET_SHORT", std::string(16, '\0'));
        content.replace(content.find("1 1 1"), 5, size);
        expectRefused(folder.write("a.mha", content), "no usable voxel size");
    }
    core::Volume volume(core::VolumeGeometry{{2, 2, 2}});
    for (const double spacing : {0.0, std::numeric_limits<double>::quiet_NaN(), -1.0}) {
        volume.geometry.spacingMm.y() = spacing;
        for (const char* name : {"a.nii", "a.nrrd", "a.mha"}) {
            const auto written = io::writeVolume(volume, folder.file(name));
            ASSERT_FALSE(written) << name << spacing;
            EXPECT_NE(written.error().message.text().find("voxel size of 1 x "), std::string::npos);
        }
    }
}

}   // namespace
