#include "io/volume_file.h"

#include "tests/io/volume/volume_bytes.h"
#include "tests/support/axis_orders.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <limits>

using namespace angiopose;

namespace {

using test::bytesOf;
using test::metaImage;
using test::readBack;
using test::TemporaryFolder;

class VolumeFormats : public ::testing::TestWithParam<const char*> {};

TEST_P(VolumeFormats, AllAxisOrdersGiveTheSamePatientPositions)
{
    const TemporaryFolder folder;
    const core::Volume original = test::countedVolume();
    for (const test::AxisOrder& order : test::allAxisOrders()) {
        const std::string path = folder.file(std::string("volume") + GetParam());
        const auto written = io::writeVolume(test::stored(original, order), path);
        ASSERT_TRUE(written) << written.error().message;

        // NIfTI-1 stores positions as 32-bit floats, whose step is 3e-5 mm at 540 mm.
        EXPECT_LT(test::largestDisplacement(original, readBack(path)), 1e-4);
    }
}

TEST_P(VolumeFormats, KeepSlopeAndInterceptInTheValues)
{
    const TemporaryFolder folder;
    core::Volume original = test::countedVolume();
    original.slope = 0.25;
    original.intercept = -7.5;
    const std::string path = folder.file(std::string("volume") + GetParam());
    ASSERT_TRUE(io::writeVolume(original, path));

    const core::Volume read = readBack(path);

    ASSERT_EQ(read.voxels.size(), original.voxels.size());
    for (std::size_t i = 0; i < read.voxels.size(); ++i) {
        EXPECT_NEAR(read.value(i), original.value(i), 2e-3);   // floats in the file are quantized to 65536 levels
    }
}

TEST_P(VolumeFormats, CutShortAnywhereSayWhatIsWrong)
{
    const TemporaryFolder folder;
    const std::string path = folder.file(std::string("volume") + GetParam());
    ASSERT_TRUE(io::writeVolume(test::countedVolume(), path));
    const std::string whole = test::readText(path);
    for (std::size_t size = 1; size + 24 < whole.size(); size += 41) {   // the last bytes are only a checksum
        folder.write(std::string("cut") + GetParam(), whole.substr(0, size));
        const auto loaded = io::readVolume(folder.file(std::string("cut") + GetParam()));
        ASSERT_FALSE(loaded) << size << " bytes";
        EXPECT_TRUE(loaded.error().message.text().ends_with(".")) << loaded.error().message;
    }
}

TEST_P(VolumeFormats, LabelsComeBackAsTheyAre)
{
    const TemporaryFolder folder;
    core::LabelVolume labels(test::countedVolume().geometry);
    labels.at(1, 2, 3) = 65535;
    labels.at(3, 4, 5) = 1;
    const std::string path = folder.file(std::string("labels") + GetParam());
    ASSERT_TRUE(io::writeLabels(labels, path));

    const auto read = io::readLabels(path);

    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read.value().voxels, labels.voxels);
}

INSTANTIATE_TEST_SUITE_P(ByExtension, VolumeFormats, ::testing::Values(".nii", ".nii.gz", ".nrrd", ".mha"));

TEST(ReadVolume, WholeNumbersOfAnyTypeKeepTheirValues)
{
    const TemporaryFolder folder;
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
    const TemporaryFolder folder;
    const std::vector<float> values = {0.0F, 0.125F, 0.25F, 1.0F, 0.7F, 0.99F, 0.5F, 0.001F};
    const auto loaded = io::readVolume(folder.write("a.mha", metaImage("MET_FLOAT", bytesOf(values))));

    ASSERT_TRUE(loaded) << loaded.error().message;
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_NEAR(loaded.value().volume.value(i), values[i], 0.5001 / 65535.0);
    }
    ASSERT_EQ(loaded.value().warnings.size(), 1U);
    EXPECT_NE(loaded.value().warnings.front().text().find("steps of 1.53e-05"), std::string::npos);
}

TEST(ReadVolume, BigEndianVoxelsAreTurned)
{
    const TemporaryFolder folder;
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
    const TemporaryFolder folder;
    const float none = std::numeric_limits<float>::quiet_NaN();
    const auto some = io::readVolume(
        folder.write("a.mha", metaImage("MET_FLOAT", bytesOf(std::vector<float>{none, 3, 4, 5, -9, 7, none, 8}))));
    ASSERT_TRUE(some);
    EXPECT_EQ(some.value().volume.value(0), -9.0);
    EXPECT_EQ(some.value().volume.value(3), 5.0);
    EXPECT_NE(some.value().warnings.front().text().find("not numbers (2 voxels)"), std::string::npos);

    test::expectRefused(folder.write("b.mha", metaImage("MET_FLOAT", bytesOf(std::vector<float>(8, none)))),
                        "no finite voxel values");
}

TEST(ReadVolume, StopEndsTheReadingWithinAChunk)
{
    const TemporaryFolder folder;
    core::VolumeGeometry geometry;
    geometry.size = {128, 128, 64};
    ASSERT_TRUE(io::writeVolume(core::Volume(geometry), folder.file("a.nii.gz")));
    int calls = 0;
    double last = 0.0;

    const auto stopped = io::readVolume(folder.file("a.nii.gz"), {}, [&](double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return ++calls == 2 ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    });

    ASSERT_FALSE(stopped);
    EXPECT_TRUE(stopped.isStopped());
    EXPECT_EQ(calls, 2);
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

}   // namespace
