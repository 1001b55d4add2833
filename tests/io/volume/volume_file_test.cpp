#include "io/volume_file.h"

#include "tests/io/scratch_folder.h"
#include "tests/support/axis_orders.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <cstring>
#include <limits>
#include <numeric>

namespace {

using test::ScratchFolder;

core::Volume readBack(const std::string& path)
{
    auto loaded = io::readVolume(path);
    EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().message);
    return loaded ? std::move(loaded).value().volume : core::Volume{};
}

template <class T>
std::string bytesOf(const std::vector<T>& values)
{
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

std::string metaImage(const std::string& type, const std::string& voxels, const std::string& more = "")
{
    return "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\n" + more + "ElementType = " + type +
           "\nElementDataFile = LOCAL\n" + voxels;
}

/// A NIfTI-1 header for 2 x 3 x 4 voxels of 16 bit, without any placement.
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
    return header + bytesOf(voxels);
}

template <class T>
void put(std::string& header, std::size_t offset, T value)
{
    std::memcpy(header.data() + offset, &value, sizeof value);
}

void expectRefused(const std::string& path, const std::string& reason)
{
    const auto loaded = io::readVolume(path);
    ASSERT_FALSE(loaded) << path;
    EXPECT_NE(loaded.error().message.find(reason), std::string::npos) << loaded.error().message;
    EXPECT_TRUE(loaded.error().message.starts_with(path)) << loaded.error().message;
}

}   // namespace

class VolumeFormats : public ::testing::TestWithParam<const char*> {};

TEST_P(VolumeFormats, AllAxisOrdersGiveTheSamePatientPositions)
{
    const ScratchFolder folder;
    const core::Volume original = test::countedVolume();
    for (const test::AxisOrder& order : test::allAxisOrders()) {
        const std::string path = folder.path(std::string("volume") + GetParam());
        const auto written = io::writeVolume(test::stored(original, order), path);
        ASSERT_TRUE(written) << written.error().message;

        // NIfTI-1 places voxels with 32-bit floats: at 540 mm these are 3e-5 mm apart.
        EXPECT_LT(test::largestDisplacement(original, readBack(path)), 1e-4);
    }
}

TEST_P(VolumeFormats, KeepSlopeAndInterceptInTheValues)
{
    const ScratchFolder folder;
    core::Volume original = test::countedVolume();
    original.slope = 0.25;
    original.intercept = -7.5;
    const std::string path = folder.path(std::string("volume") + GetParam());
    ASSERT_TRUE(io::writeVolume(original, path));

    const core::Volume read = readBack(path);

    ASSERT_EQ(read.voxels.size(), original.voxels.size());
    for (std::size_t i = 0; i < read.voxels.size(); ++i) {
        EXPECT_NEAR(read.value(i), original.value(i), 2e-3);   // floats in the file take one of 65536 levels
    }
}

TEST_P(VolumeFormats, CutShortAnywhereSayWhatIsWrong)
{
    const ScratchFolder folder;
    const std::string path = folder.path(std::string("volume") + GetParam());
    ASSERT_TRUE(io::writeVolume(test::countedVolume(), path));
    const std::string whole = test::contentOf(path);
    for (std::size_t size = 1; size + 24 < whole.size(); size += 41) {   // the last bytes are a checksum only
        folder.write(std::string("cut") + GetParam(), whole.substr(0, size));
        const auto loaded = io::readVolume(folder.path(std::string("cut") + GetParam()));
        ASSERT_FALSE(loaded) << size << " bytes";
        EXPECT_TRUE(loaded.error().message.ends_with(".")) << loaded.error().message;
    }
}

TEST_P(VolumeFormats, LabelsComeBackAsTheyAre)
{
    const ScratchFolder folder;
    core::LabelVolume labels(test::countedVolume().geometry);
    labels.at(1, 2, 3) = 65535;
    labels.at(3, 4, 5) = 1;
    const std::string path = folder.path(std::string("labels") + GetParam());
    ASSERT_TRUE(io::writeLabels(labels, path));

    const auto read = io::readLabels(path);

    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read.value().voxels, labels.voxels);
}

INSTANTIATE_TEST_SUITE_P(ByExtension, VolumeFormats, ::testing::Values(".nii", ".nii.gz", ".nrrd", ".mha"));

TEST(ReadVolume, WholeNumbersOfAnyTypeKeepTheirValues)
{
    const ScratchFolder folder;
    const std::vector<double> values = {0, 1, 2, 3, 100, 127, 50, 7};
    const auto expectKept = [&](const std::string& type, const std::string& voxels, double offset) {
        const auto loaded = io::readVolume(folder.write("a.mha", metaImage(type, voxels)));
        ASSERT_TRUE(loaded) << loaded.error().message;
        for (std::size_t i = 0; i < values.size(); ++i) {
            EXPECT_EQ(loaded.value().volume.value(i), values[i] + offset) << type;
        }
        EXPECT_TRUE(loaded.value().warnings.empty()) << type;
    };
    const auto as = [&](auto kind, double offset) {
        std::vector<decltype(kind)> typed;
        for (const double value : values) {
            typed.push_back(static_cast<decltype(kind)>(value + offset));
        }
        return bytesOf(typed);
    };
    expectKept("MET_CHAR", as(std::int8_t{}, -90.0), -90.0);
    expectKept("MET_UCHAR", as(std::uint8_t{}, 100.0), 100.0);
    expectKept("MET_SHORT", as(std::int16_t{}, -1024.0), -1024.0);
    expectKept("MET_USHORT", as(std::uint16_t{}, 65000.0), 65000.0);
    expectKept("MET_INT", as(std::int32_t{}, 1e6), 1e6);
    expectKept("MET_UINT", as(std::uint32_t{}, 4e9), 4e9);
    expectKept("MET_LONG_LONG", as(std::int64_t{}, -5e9), -5e9);
    expectKept("MET_FLOAT", as(float{}, -300.0), -300.0);
    expectKept("MET_DOUBLE", as(double{}, 1e7), 1e7);
}

TEST(ReadVolume, FractionsAreRoundedAndItSaysSo)
{
    const ScratchFolder folder;
    const std::vector<float> values = {0.0F, 0.125F, 0.25F, 1.0F, 0.7F, 0.99F, 0.5F, 0.001F};
    const auto loaded = io::readVolume(folder.write("a.mha", metaImage("MET_FLOAT", bytesOf(values))));

    ASSERT_TRUE(loaded) << loaded.error().message;
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_NEAR(loaded.value().volume.value(i), values[i], 0.5001 / 65535.0);
    }
    ASSERT_EQ(loaded.value().warnings.size(), 1U);
    EXPECT_NE(loaded.value().warnings.front().find("steps of 1.53e-05"), std::string::npos);
}

TEST(ReadVolume, BigEndianVoxelsAreTurned)
{
    const ScratchFolder folder;
    std::string voxels(16, '\0');
    voxels[0] = 1;   // 256
    voxels[3] = 2;   // 2
    const core::Volume volume =
        readBack(folder.write("a.mha", metaImage("MET_SHORT", voxels, "BinaryDataByteOrderMSB = True\n")));
    EXPECT_EQ(volume.value(0), 256.0);
    EXPECT_EQ(volume.value(1), 2.0);
}

TEST(ReadVolume, NotANumberBecomesTheLowestValue)
{
    const ScratchFolder folder;
    const float none = std::numeric_limits<float>::quiet_NaN();
    const auto some = io::readVolume(
        folder.write("a.mha", metaImage("MET_FLOAT", bytesOf(std::vector<float>{none, 3, 4, 5, -9, 7, none, 8}))));
    ASSERT_TRUE(some);
    EXPECT_EQ(some.value().volume.value(0), -9.0);
    EXPECT_EQ(some.value().volume.value(3), 5.0);
    EXPECT_NE(some.value().warnings.front().find("2 voxels are not numbers"), std::string::npos);

    expectRefused(folder.write("b.mha", metaImage("MET_FLOAT", bytesOf(std::vector<float>(8, none)))),
                  "none of its voxels is a number");
}

TEST(ReadVolume, StopEndsTheReadingWithinAChunk)
{
    const ScratchFolder folder;
    core::VolumeGeometry geometry;
    geometry.size = {128, 128, 64};
    ASSERT_TRUE(io::writeVolume(core::Volume(geometry), folder.path("a.nii.gz")));
    int calls = 0;
    double last = 0.0;

    const auto stopped = io::readVolume(folder.path("a.nii.gz"), {}, [&](double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return ++calls == 2 ? core::Verdict::Stop : core::Verdict::Continue;
    });

    ASSERT_FALSE(stopped);
    EXPECT_NE(stopped.error().message.find("stopped"), std::string::npos);
    EXPECT_EQ(calls, 2);
}

TEST(Nifti, SformWinsAndRasBecomesLps)
{
    const ScratchFolder folder;
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
    const ScratchFolder folder;
    std::string header = plainNifti();
    put(header, 252, std::int16_t{1});
    put(header, 76, -1.0F);   // k reversed
    put(header, 256, std::array<float, 6>{0, 0, 1, 5, 6, 7});   // half a turn about z

    const core::Volume volume = readBack(folder.write("a.nii", withVoxels(header, 24)));

    const Eigen::Affine3d map = volume.geometry.patientFromVoxel();
    EXPECT_LT((map * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(-4.5, -6, 7)).norm(), 1e-5);
    EXPECT_LT((map * Eigen::Vector3d(0, 1, 0) - Eigen::Vector3d(-5, -4, 7)).norm(), 1e-5);
    EXPECT_LT((map * Eigen::Vector3d(0, 0, 1) - Eigen::Vector3d(-5, -6, 4)).norm(), 1e-5);
}

TEST(Nifti, TheScannersPlacementBeatsAnAtlas)
{
    const ScratchFolder folder;
    std::string header = plainNifti();
    put(header, 252, std::int16_t{1});
    put(header, 256, std::array<float, 6>{0, 0, 0, 5, 6, 7});
    put(header, 254, std::int16_t{4});   // MNI 152
    put(header, 280, std::array<float, 12>{1, 0, 0, 99, 0, 1, 0, 99, 0, 0, 1, 99});

    const auto loaded = io::readVolume(folder.write("a.nii", withVoxels(header, 24)));

    ASSERT_TRUE(loaded);
    EXPECT_LT((loaded.value().volume.geometry.originInPatient - Eigen::Vector3d(-5, -6, 7)).norm(), 1e-5);
    EXPECT_NE(loaded.value().warnings.front().find("qform"), std::string::npos);
}

TEST(Nifti, SaysWhenThePlacementIsUnknown)
{
    const ScratchFolder folder;
    const auto loaded = io::readVolume(folder.write("a.nii", withVoxels(plainNifti(), 24)));
    ASSERT_TRUE(loaded);
    EXPECT_LT((loaded.value().volume.geometry.spacingMm - Eigen::Vector3d(0.5, 2.0, 3.0)).norm(), 1e-6);
    ASSERT_EQ(loaded.value().warnings.size(), 1U);
    EXPECT_NE(loaded.value().warnings.front().find("left and right"), std::string::npos);
}

TEST(Nifti, RefusesWhatIsNoVolume)
{
    const ScratchFolder folder;
    std::string series = plainNifti();
    put(series, 40, std::array<std::int16_t, 8>{4, 2, 3, 4, 7, 1, 1, 1});
    expectRefused(folder.write("4d.nii", series), "7 volumes");

    std::string colour = plainNifti();
    put(colour, 70, std::int16_t{128});
    expectRefused(folder.write("rgb.nii", colour), "colours");

    std::string huge = plainNifti();
    put(huge, 40, std::array<std::int16_t, 8>{3, 30000, 30000, 30000, 1, 1, 1, 1});
    expectRefused(folder.write("huge.nii", huge), "more than this program holds");

    std::string lying = plainNifti();
    put(lying, 40, std::array<std::int16_t, 8>{3, 1000, 1000, 1000, 1, 1, 1, 1});
    expectRefused(folder.write("lying.nii", lying), "cut short");

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
    const ScratchFolder folder;
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
    EXPECT_NE(unknown.value().warnings.front().find("left and right"), std::string::npos);
}

TEST(MetaImage, NamesHeaderAndVoxelsWhenTheseAreMissing)
{
    const ScratchFolder folder;
    const std::string header = metaImage("MET_SHORT", "");
    const std::string path = folder.write("scan.mhd", header.substr(0, header.find("LOCAL")) + "elsewhere.raw\n");
    expectRefused(path, "elsewhere.raw");
}

TEST(LooksLikeLabels, TellsMasksFromScans)
{
    core::VolumeGeometry geometry;
    geometry.size = {20, 20, 20};
    core::Volume mask(geometry);
    mask.at(3, 3, 3) = 1;
    EXPECT_TRUE(io::looksLikeLabels(mask));

    core::Volume pieces(geometry);
    for (int k = 5; k < 10; ++k) {
        for (int i = 2; i < 12; ++i) {
            pieces.at(i, 8, k) = static_cast<std::int16_t>(k);
        }
    }
    EXPECT_TRUE(io::looksLikeLabels(pieces));

    core::Volume scan = test::countedVolume({20, 20, 20});
    EXPECT_FALSE(io::looksLikeLabels(scan)) << "negative";
    scan.intercept = 50.0;
    EXPECT_FALSE(io::looksLikeLabels(scan)) << "every value once";
}

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
