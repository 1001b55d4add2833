#include "io/dicom_series.h"

#include "io/volume_file.h"
#include "tests/io/scratch_folder.h"
#include "tests/io/series/dicom_slices.h"
#include "tests/support/axis_orders.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <numeric>

namespace {

using test::CtSlice;
using test::ScratchFolder;

/// The slice of `volume` at layer k, as a scanner would store it.
CtSlice sliceOf(const core::Volume& volume, int k)
{
    const core::VolumeGeometry& geometry = volume.geometry;
    CtSlice slice;
    slice.columns = geometry.size.x();
    slice.rows = geometry.size.y();
    slice.columnSpacingMm = geometry.spacingMm.x();
    slice.rowSpacingMm = geometry.spacingMm.y();
    const Eigen::Vector3d position = geometry.patientFromVoxel() * Eigen::Vector3d(0, 0, k);
    slice.position.assign(position.data(), position.data() + 3);
    slice.orientation.assign(geometry.direction.data(), geometry.direction.data() + 6);
    slice.instanceNumber = k + 1;
    slice.sopInstanceUid = "1.2.3." + std::to_string(k + 1);
    const auto first = volume.voxels.begin() + static_cast<std::ptrdiff_t>(geometry.index(0, 0, k));
    slice.pixels.assign(first, first + static_cast<std::ptrdiff_t>(slice.columns) * slice.rows);
    return slice;
}

core::Volume ctPhantom()
{
    core::Volume volume = test::countedVolume({8, 9, 10});
    volume.intercept = -1024.0;
    return volume;
}

/// Writes slices under names that say nothing about their order.
void writeShuffled(const ScratchFolder& folder, const std::vector<CtSlice>& slices)
{
    for (std::size_t i = 0; i < slices.size(); ++i) {
        folder.write(std::to_string(7919 * (i + 1) % 1000) + "_" + std::to_string(i), test::ctSlice(slices[i]));
    }
}

std::vector<CtSlice> allSlices(const core::Volume& volume)
{
    std::vector<CtSlice> slices;
    for (int k = 0; k < volume.geometry.size.z(); ++k) {
        slices.push_back(sliceOf(volume, k));
    }
    return slices;
}

io::LoadedVolume readFolder(const ScratchFolder& folder)
{
    auto loaded = io::readVolume(folder.path(""));
    EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().message);
    return loaded ? std::move(loaded).value() : io::LoadedVolume{};
}

bool mentions(const std::vector<std::string>& warnings, const std::string& words)
{
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

}   // namespace

TEST(DicomSeries, ComesTogetherFromShuffledFiles)
{
    const ScratchFolder folder;
    const core::Volume phantom = ctPhantom();
    writeShuffled(folder, allSlices(phantom));
    folder.write("notes.txt", "not DICOM");
    folder.write("nested/more.txt", "neither");

    const io::LoadedVolume loaded = readFolder(folder);

    EXPECT_LT(test::largestDisplacement(phantom, loaded.volume), 1e-6);
    EXPECT_EQ(loaded.identity.patientName, "Phantom^CT");
    EXPECT_TRUE(loaded.warnings.empty()) << loaded.warnings.front();
}

TEST(DicomSeries, AnyOrientationGivesTheSamePatientPositions)
{
    const core::Volume phantom = ctPhantom();
    for (const test::AxisOrder& order : test::allAxisOrders()) {
        const ScratchFolder folder;
        const core::Volume stored = test::stored(phantom, order);
        writeShuffled(folder, allSlices(stored));

        EXPECT_LT(test::largestDisplacement(phantom, readFolder(folder).volume), 1e-6);
    }
}

TEST(DicomSeries, OneSliceOpensTheOthersBesideIt)
{
    const ScratchFolder folder;
    const core::Volume phantom = ctPhantom();
    writeShuffled(folder, allSlices(phantom));
    const auto first = *std::filesystem::directory_iterator(folder.path(""));

    const auto loaded = io::readVolume(first.path().string());

    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_LT(test::largestDisplacement(phantom, loaded.value().volume), 1e-6);
}

TEST(DicomSeries, APreambleOfAnotherFormatDoesNotMislead)
{
    const ScratchFolder folder;
    const core::Volume phantom = ctPhantom();
    for (const CtSlice& slice : allSlices(phantom)) {
        std::string content = test::ctSlice(slice);
        content[0] = 0x5c;   // 348, as an Analyze header begins
        content[1] = 0x01;
        folder.write(slice.sopInstanceUid, content);
    }
    const auto loaded = io::readVolume(folder.path("1.2.3.4"));
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded.value().volume.geometry.size, phantom.geometry.size);
}

TEST(DicomSeries, TwoInOneFolderAreToldApart)
{
    const ScratchFolder folder;
    const core::Volume phantom = ctPhantom();
    std::vector<CtSlice> slices = allSlices(phantom);
    for (CtSlice slice : allSlices(phantom)) {
        if (slice.instanceNumber <= 4) {
            slice.seriesUid = "1.2.99";
            slice.description = "native";
            slice.sopInstanceUid += ".99";
            slices.push_back(slice);
        }
    }
    writeShuffled(folder, slices);

    const auto series = io::listSeries(folder.path(""));

    ASSERT_TRUE(series);
    ASSERT_EQ(series.value().size(), 2U);
    EXPECT_EQ(series.value()[0].description, "CTA 0.75");
    EXPECT_EQ(series.value()[0].stack.geometry.size, phantom.geometry.size);
    EXPECT_EQ(series.value()[1].description, "native");
    EXPECT_EQ(series.value()[1].identity.studyDate, "2026-04-01");
    EXPECT_FALSE(io::readVolume(folder.path(""))) << "must be chosen";
    const auto chosen = io::readVolume(folder.path(""), "1.2.99");
    ASSERT_TRUE(chosen) << chosen.error().message;
    EXPECT_EQ(chosen.value().volume.geometry.size.z(), 4);
    EXPECT_FALSE(io::readVolume(folder.path(""), "1.2.98"));
}

TEST(DicomSeries, AMissingSliceIsFilledAndNamed)
{
    const ScratchFolder folder;
    core::Volume phantom = ctPhantom();   // values grow linearly along k, so that the middle of two slices is known
    std::vector<CtSlice> slices = allSlices(phantom);
    slices.erase(slices.begin() + 4);
    writeShuffled(folder, slices);

    const io::LoadedVolume loaded = readFolder(folder);

    EXPECT_LT(test::largestDisplacement(phantom, loaded.volume), 1e-6);
    EXPECT_TRUE(mentions(loaded.warnings, "1 of 10 slices is missing (after slice 4)"));
}

TEST(DicomSeries, UnevenSpacingIsResampled)
{
    const ScratchFolder folder;
    const core::Volume phantom = ctPhantom();
    std::vector<CtSlice> slices = allSlices(phantom);
    const Eigen::Vector3d along = phantom.geometry.direction.col(2);
    const std::vector<double> places = {0, 1.25, 2.5, 3.75, 5, 5.8, 7.6, 8.75, 10, 11.25};
    for (std::size_t k = 0; k < slices.size(); ++k) {
        const Eigen::Vector3d position = phantom.geometry.originInPatient + places[k] * along;
        slices[k].position.assign(position.data(), position.data() + 3);
        std::fill(slices[k].pixels.begin(), slices[k].pixels.end(), static_cast<std::int16_t>(100.0 * places[k]));
    }
    writeShuffled(folder, slices);

    const io::LoadedVolume loaded = readFolder(folder);

    EXPECT_TRUE(mentions(loaded.warnings, "unevenly spaced (0.8 to 1.8 mm)"));
    const core::VolumeGeometry& geometry = loaded.volume.geometry;
    for (int k = 0; k < geometry.size.z(); ++k) {
        const double place = k * geometry.spacingMm.z();
        EXPECT_NEAR(loaded.volume.value(geometry.index(3, 3, k)) + 1024.0, 100.0 * place, 13.0) << k;
    }
}

TEST(DicomSeries, ATiltedGantryIsShiftedUpright)
{
    const ScratchFolder folder;
    core::VolumeGeometry geometry;
    geometry.size = {16, 40, 12};
    geometry.spacingMm = {1, 1, 2};
    const double tilt = 0.25;   // the tops of the slices lean back by this per mm
    // A straight rod along z in the patient: with a tilted gantry it wanders over the rows.
    std::vector<CtSlice> slices;
    for (int k = 0; k < 12; ++k) {
        CtSlice slice;
        slice.columns = 16;
        slice.rows = 40;
        slice.columnSpacingMm = slice.rowSpacingMm = 1.0;
        slice.sopInstanceUid = "1.2.3." + std::to_string(k);
        slice.position = {0.0, -tilt * 2.0 * k, 2.0 * k};
        slice.pixels.assign(16 * 40, 0);
        for (int j = 0; j < 40; ++j) {
            const double y = slice.position[1] + j;
            slice.pixels[static_cast<std::size_t>(16 * j + 5)] =
                static_cast<std::int16_t>(1000.0 * std::max(0.0, 1.0 - std::abs(y - 10.0) / 3.0));
        }
        slices.push_back(slice);
    }
    writeShuffled(folder, slices);

    const io::LoadedVolume loaded = readFolder(folder);

    EXPECT_TRUE(mentions(loaded.warnings, "14°"));
    const core::VolumeGeometry& upright = loaded.volume.geometry;
    EXPECT_TRUE(upright.direction.isIdentity(1e-9));
    for (int k = 0; k < upright.size.z(); ++k) {
        double weight = 0.0, sum = 0.0;
        for (int j = 0; j < upright.size.y(); ++j) {
            const double value = std::max(0.0, loaded.volume.value(upright.index(5, j, k)) + 1000.0);
            weight += value;
            sum += value * (upright.patientFromVoxel() * Eigen::Vector3d(5, j, k)).y();
        }
        EXPECT_NEAR(sum / weight, 10.0, 0.15) << "layer " << k;
    }
}

TEST(DicomSeries, PhasesAtTheSamePlaceBecomeVolumesOfTheirOwn)
{
    const ScratchFolder folder;
    std::vector<CtSlice> slices = allSlices(ctPhantom());
    for (CtSlice slice : allSlices(ctPhantom())) {
        slice.acquisition = "2";
        slice.sopInstanceUid += ".2";
        slice.instanceNumber += 10;
        slices.push_back(slice);
    }
    writeShuffled(folder, slices);

    const auto series = io::listSeries(folder.path(""));

    ASSERT_TRUE(series);
    ASSERT_EQ(series.value().size(), 2U);
    EXPECT_EQ(series.value()[0].slices.size(), 10U);
    EXPECT_EQ(series.value()[1].part, "part 2 of 2");
    EXPECT_NE(series.value()[0].id, series.value()[1].id);
}

TEST(DicomSeries, CopiesAndStrayDuplicatesAreDropped)
{
    const ScratchFolder folder;
    const core::Volume phantom = ctPhantom();
    std::vector<CtSlice> slices = allSlices(phantom);
    slices.push_back(slices[3]);   // the same file twice
    CtSlice again = slices[5];   // another image at the place of the sixth slice
    again.sopInstanceUid = "1.2.3.77";
    again.instanceNumber = 77;
    again.pixels.assign(again.pixels.size(), 0);
    slices.push_back(again);
    writeShuffled(folder, slices);

    const io::LoadedVolume loaded = readFolder(folder);

    EXPECT_LT(test::largestDisplacement(phantom, loaded.volume), 1e-6);
    EXPECT_TRUE(mentions(loaded.warnings, "1 files of the series are there twice"));
    EXPECT_TRUE(mentions(loaded.warnings, "first recorded"));
}

TEST(DicomSeries, ScoutsOfTheSameSeriesAreListedApart)
{
    const ScratchFolder folder;
    std::vector<CtSlice> slices = allSlices(ctPhantom());
    CtSlice scout = slices.front();
    scout.sopInstanceUid = "1.2.3.500";
    scout.orientation = {1, 0, 0, 0, 0, -1};
    slices.push_back(scout);
    writeShuffled(folder, slices);

    const auto series = io::listSeries(folder.path(""));

    ASSERT_TRUE(series);
    ASSERT_EQ(series.value().size(), 2U);
    EXPECT_TRUE(series.value()[0].problem.empty());
    EXPECT_NE(series.value()[1].problem.find("single slice"), std::string::npos);
    EXPECT_TRUE(mentions(series.value()[0].warnings, "sizes or orientations"));
    EXPECT_TRUE(io::readVolume(folder.path(""))) << "the scout leaves no choice";
}

TEST(DicomSeries, DifferentScalesKeepTheirValues)
{
    const ScratchFolder folder;
    core::Volume phantom = ctPhantom();
    std::vector<CtSlice> slices = allSlices(phantom);
    for (std::size_t k = 0; k < slices.size(); k += 2) {   // stored as half values
        slices[k].slope = 2.0;
        slices[k].intercept = -1024.0;
        for (std::int16_t& pixel : slices[k].pixels) {
            pixel = static_cast<std::int16_t>(2 * (pixel / 2) / 2);
        }
    }
    writeShuffled(folder, slices);

    const io::LoadedVolume loaded = readFolder(folder);

    for (int k = 0; k < 10; ++k) {
        const std::size_t at = phantom.geometry.index(3, 4, k);
        EXPECT_NEAR(loaded.volume.value(at), phantom.value(at), k % 2 == 0 ? 1.0 : 0.0) << k;
    }
}

TEST(DicomSeries, DamagedSlicesAndEmptyFoldersSayWhatIsWrong)
{
    const ScratchFolder folder;
    std::vector<CtSlice> slices = allSlices(ctPhantom());
    slices[2].pixels.resize(20);
    writeShuffled(folder, slices);
    const auto loaded = io::readVolume(folder.path(""));
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error().message.find("cut short"), std::string::npos) << loaded.error().message;

    const ScratchFolder empty;
    std::filesystem::create_directories(empty.path("nothing"));
    const auto none = io::listSeries(empty.path("nothing"));
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("no DICOM image"), std::string::npos);
}

TEST(DicomSeries, StopIsAnsweredWhileListingAndReading)
{
    const ScratchFolder folder;
    writeShuffled(folder, allSlices(ctPhantom()));
    const auto stop = [](double) { return core::Verdict::Stop; };
    EXPECT_FALSE(io::listSeries(folder.path(""), stop));
    auto series = io::listSeries(folder.path(""));
    ASSERT_TRUE(series);
    std::vector<std::string> warnings;
    const auto volume = io::readSeries(series.value().front(), stop, warnings);
    ASSERT_FALSE(volume);
    EXPECT_NE(volume.error().message.find("stopped"), std::string::npos);
}

TEST(DicomSeries, HashFollowsContentNotNames)
{
    const ScratchFolder a, b;
    writeShuffled(a, allSlices(ctPhantom()));
    std::vector<CtSlice> reversed = allSlices(ctPhantom());
    std::reverse(reversed.begin(), reversed.end());
    std::filesystem::create_directories(b.path("sub"));
    for (std::size_t i = 0; i < reversed.size(); ++i) {
        b.write("sub/" + std::to_string(i), test::ctSlice(reversed[i]));
    }
    const auto first = io::sha256OfSeries(io::listSeries(a.path("")).value().front());
    const auto second = io::sha256OfSeries(io::listSeries(b.path("sub")).value().front());
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first.value(), second.value());
}

TEST(RealSeries, WithEmptyUidsAndJpeg2000Loads)
{
    ANGIOPOSE_NEEDS_DATA("abdomen-ct/dicom-series-j2k");
    const auto loaded = io::readVolume(test::dataFile("abdomen-ct/dicom-series-j2k").string());
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded.value().volume.geometry.size, Eigen::Vector3i(512, 512, 20));
    EXPECT_NEAR(loaded.value().volume.geometry.spacingMm.z(), 2.0, 1e-6);
    EXPECT_TRUE(loaded.value().warnings.empty()) << loaded.value().warnings.front();
}

TEST(RealSeries, EnhancedMultiFrameCtLoadsFromOneFile)
{
    ANGIOPOSE_NEEDS_DATA("exotic-dicom/pydicom-data/eCT_Supplemental.dcm");
    const auto loaded = io::readVolume(test::dataFile("exotic-dicom/pydicom-data/eCT_Supplemental.dcm").string());
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded.value().volume.geometry.size.head<2>(), Eigen::Vector2i(512, 512));
}
