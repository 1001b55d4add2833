#include "io/dicom_series.h"

#include "io/messages/messages.h"
#include "tests/io/series/ct_phantom.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>

using namespace angiopose;

namespace {

using test::allSlices;
using test::ctPhantom;
using test::CtSlice;
using test::mentions;
using test::readFolder;
using test::TemporaryFolder;
using test::writeShuffled;

TEST(DicomSeries, ComesTogetherFromShuffledFiles)
{
    const TemporaryFolder folder;
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
        const TemporaryFolder folder;
        const core::Volume stored = test::stored(phantom, order);
        writeShuffled(folder, allSlices(stored));

        EXPECT_LT(test::largestDisplacement(phantom, readFolder(folder).volume), 1e-6);
    }
}

TEST(DicomSeries, OneSliceOpensTheOthersBesideIt)
{
    const TemporaryFolder folder;
    const core::Volume phantom = ctPhantom();
    writeShuffled(folder, allSlices(phantom));
    const auto first = *std::filesystem::directory_iterator(folder.file(""));

    const auto loaded = io::readVolume(first.path().string());

    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_LT(test::largestDisplacement(phantom, loaded.value().volume), 1e-6);
}

TEST(DicomSeries, APreambleOfAnotherFormatDoesNotMislead)
{
    const TemporaryFolder folder;
    const core::Volume phantom = ctPhantom();
    for (const CtSlice& slice : allSlices(phantom)) {
        std::string content = test::ctSlice(slice);
        content[0] = 0x5c;   // 348, the first bytes of an Analyze header
        content[1] = 0x01;
        folder.write(slice.sopInstanceUid, content);
    }
    const auto loaded = io::readVolume(folder.file("1.2.3.4"));
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded.value().volume.geometry.size, phantom.geometry.size);
}

TEST(DicomSeries, TwoInOneFolderAreToldApart)
{
    const TemporaryFolder folder;
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

    const auto series = io::listSeries(folder.file(""));

    ASSERT_TRUE(series);
    ASSERT_EQ(series.value().size(), 2U);
    EXPECT_EQ(series.value()[0].description, "CTA 0.75");
    EXPECT_EQ(series.value()[0].stack.geometry.size, phantom.geometry.size);
    EXPECT_EQ(series.value()[1].description, "native");
    EXPECT_EQ(series.value()[1].identity.studyDate, "2026-04-01");
    EXPECT_FALSE(io::readVolume(folder.file(""))) << "must be chosen";
    const auto chosen = io::readVolume(folder.file(""), "1.2.99");
    ASSERT_TRUE(chosen) << chosen.error().message;
    EXPECT_EQ(chosen.value().volume.geometry.size.z(), 4);
    EXPECT_FALSE(io::readVolume(folder.file(""), "1.2.98"));
}

TEST(DicomSeries, PhasesAtTheSamePlaceBecomeVolumesOfTheirOwn)
{
    const TemporaryFolder folder;
    std::vector<CtSlice> slices = allSlices(ctPhantom());
    for (CtSlice slice : allSlices(ctPhantom())) {
        slice.acquisition = "2";
        slice.sopInstanceUid += ".2";
        slice.instanceNumber += 10;
        slices.push_back(slice);
    }
    writeShuffled(folder, slices);

    const auto series = io::listSeries(folder.file(""));

    ASSERT_TRUE(series);
    ASSERT_EQ(series.value().size(), 2U);
    EXPECT_EQ(series.value()[0].slices.size(), 10U);
    ASSERT_TRUE(series.value()[1].part);
    EXPECT_EQ(series.value()[1].part->text(), "part 2 of 2 (acquisition 2)");
    EXPECT_NE(series.value()[0].id, series.value()[1].id);
}

TEST(DicomSeries, CopiesAndStrayDuplicatesAreDropped)
{
    const TemporaryFolder folder;
    const core::Volume phantom = ctPhantom();
    std::vector<CtSlice> slices = allSlices(phantom);
    slices.push_back(slices[3]);   // the same file twice
    CtSlice again = slices[5];   // another image at the position of the sixth slice
    again.sopInstanceUid = "1.2.3.77";
    again.instanceNumber = 77;
    again.pixels.assign(again.pixels.size(), 0);
    slices.push_back(again);
    writeShuffled(folder, slices);

    const io::LoadedVolume loaded = readFolder(folder);

    EXPECT_LT(test::largestDisplacement(phantom, loaded.volume), 1e-6);
    EXPECT_TRUE(mentions(loaded.warnings, "Duplicate files of the series are ignored (number: 1)"));
    EXPECT_TRUE(mentions(loaded.warnings, "acquired first"));
}

TEST(DicomSeries, SlicesThatShareAUidAreStillSlices)
{
    const TemporaryFolder folder;
    const core::Volume phantom = ctPhantom();
    std::vector<CtSlice> slices = allSlices(phantom);
    for (CtSlice& slice : slices) {
        slice.sopInstanceUid = "1.2.3.99";
    }
    slices.push_back(slices[3]);   // and one of them twice
    writeShuffled(folder, slices);

    const io::LoadedVolume loaded = readFolder(folder);

    EXPECT_EQ(loaded.volume.geometry.size.z(), 10);
    EXPECT_LT(test::largestDisplacement(phantom, loaded.volume), 1e-6);
    EXPECT_TRUE(mentions(loaded.warnings, "Duplicate files of the series are ignored (number: 1)"));
    EXPECT_TRUE(mentions(loaded.warnings, "10 of 10 images of the series share an SOP Instance UID"));
}

/// The second acquisition starts `offsetMm` above the first.
std::vector<io::DicomSeries> seriesOfTwoAcquisitions(double offsetMm)
{
    const TemporaryFolder folder;
    std::vector<CtSlice> slices = allSlices(ctPhantom());
    const core::VolumeGeometry geometry = ctPhantom().geometry;
    for (CtSlice slice : allSlices(ctPhantom())) {
        for (int axis = 0; axis < 3; ++axis) {
            slice.position[static_cast<std::size_t>(axis)] += offsetMm * geometry.direction(axis, 2);
        }
        slice.acquisition = "2";
        slice.sopInstanceUid += ".2";
        slices.push_back(slice);
    }
    writeShuffled(folder, slices);
    auto series = io::listSeries(folder.file(""));
    EXPECT_TRUE(series);
    return series ? std::move(series).value() : std::vector<io::DicomSeries>{};
}

TEST(DicomSeries, AcquisitionsThatAreNoVolumeTogetherAreNamedAndParted)
{
    const double step = ctPhantom().geometry.spacingMm.z();
    for (const double offset : {0.5 * step, 0.3 * step, 40.0 * step}) {   // between the slices, and far beyond them
        const std::vector<io::DicomSeries> series = seriesOfTwoAcquisitions(offset);
        ASSERT_EQ(series.size(), 2U) << offset;
        for (const io::DicomSeries& each : series) {
            EXPECT_EQ(each.slices.size(), 10U);
            EXPECT_NEAR(each.stack.geometry.spacingMm.z(), step, 1e-9);
            EXPECT_TRUE(each.warnings.empty()) << each.warnings.front();
        }
        EXPECT_EQ(series[1].part->text(), "part 2 of 2 (acquisition 2)");
    }
    const std::vector<io::DicomSeries> slabs = seriesOfTwoAcquisitions(10.0 * step);   // one table step after another
    ASSERT_EQ(slabs.size(), 1U);
    EXPECT_EQ(slabs[0].slices.size(), 20U);
}

TEST(DicomSeries, PatientsWithOneSeriesUidStayApart)
{
    const TemporaryFolder folder;
    std::vector<CtSlice> slices = allSlices(ctPhantom());
    for (CtSlice slice : allSlices(ctPhantom())) {
        slice.patientName = "Other";
        slice.patientId = "2";
        slice.sopInstanceUid += ".2";
        slices.push_back(slice);
    }
    writeShuffled(folder, slices);

    const auto series = io::listSeries(folder.file(""));

    ASSERT_TRUE(series);
    ASSERT_EQ(series.value().size(), 2U);
    EXPECT_NE(series.value()[0].id, series.value()[1].id);
    EXPECT_NE(series.value()[0].identity.patientName, series.value()[1].identity.patientName);
    EXPECT_TRUE(mentions(series.value()[0].warnings, "2 patients or studies share the UID"));
}

TEST(DicomSeries, ScoutsOfTheSameSeriesAreListedApart)
{
    const TemporaryFolder folder;
    std::vector<CtSlice> slices = allSlices(ctPhantom());
    CtSlice scout = slices.front();
    scout.sopInstanceUid = "1.2.3.500";
    scout.orientation = {1, 0, 0, 0, 0, -1};
    slices.push_back(scout);
    writeShuffled(folder, slices);

    const auto series = io::listSeries(folder.file(""));

    ASSERT_TRUE(series);
    ASSERT_EQ(series.value().size(), 2U);
    EXPECT_FALSE(series.value()[0].problem);
    EXPECT_EQ(series.value()[1].problem, io::messages::seriesSingleSlice());
    EXPECT_TRUE(mentions(series.value()[0].warnings, "sizes or orientations"));
    EXPECT_TRUE(io::readVolume(folder.file(""))) << "the scout leaves no choice";
}

TEST(DicomSeries, DamagedSlicesAndEmptyFoldersSayWhatIsWrong)
{
    const TemporaryFolder folder;
    std::vector<CtSlice> slices = allSlices(ctPhantom());
    slices[2].pixels.resize(20);
    writeShuffled(folder, slices);
    const auto loaded = io::readVolume(folder.file(""));
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error().message.text().find("truncated"), std::string::npos) << loaded.error().message;

    const TemporaryFolder empty;
    std::filesystem::create_directories(empty.file("nothing"));
    const auto none = io::listSeries(empty.file("nothing"));
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.text().find("no DICOM image"), std::string::npos);
}

TEST(DicomSeries, StopIsAnsweredWhileListingAndReading)
{
    const TemporaryFolder folder;
    writeShuffled(folder, allSlices(ctPhantom()));
    const auto stop = [](double) { return core::ObserverDecision::Stop; };
    EXPECT_FALSE(io::listSeries(folder.file(""), stop));
    auto series = io::listSeries(folder.file(""));
    ASSERT_TRUE(series);
    core::Messages warnings;
    const auto volume = io::readSeries(series.value().front(), stop, warnings);
    ASSERT_FALSE(volume);
    EXPECT_TRUE(volume.isStopped());
}

TEST(DicomSeries, HashFollowsContentNotNames)
{
    const TemporaryFolder a, b;
    writeShuffled(a, allSlices(ctPhantom()));
    std::vector<CtSlice> reversed = allSlices(ctPhantom());
    std::reverse(reversed.begin(), reversed.end());
    std::filesystem::create_directories(b.file("sub"));
    for (std::size_t i = 0; i < reversed.size(); ++i) {
        b.write("sub/" + std::to_string(i), test::ctSlice(reversed[i]));
    }
    const auto first = io::sha256OfSeries(io::listSeries(a.file("")).value().front());
    const auto second = io::sha256OfSeries(io::listSeries(b.file("sub")).value().front());
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

}   // namespace
