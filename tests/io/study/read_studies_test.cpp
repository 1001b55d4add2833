#include "io/study/read_studies.h"
#include "io/study/dicom_directory.h"
#include "io/study/series_thumbnail.h"
#include "io/study/study_file.h"
#include "tests/io/series/ct_phantom.h"
#include "tests/io/study/study_disc.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <filesystem>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

StudyTree read(const std::string& place, StudyScope scope = StudyScope::Listed, const StudyObserver& observe = {})
{
    auto tree = readStudies(place, scope, observe);
    EXPECT_TRUE(tree) << (tree ? "" : tree.error().message.text());
    return tree ? std::move(tree).value() : StudyTree{};
}

std::vector<StudySeries> seriesOf(const StudyTree& tree)
{
    std::vector<StudySeries> all;
    for (const StudyPatient& patient : tree.patients) {
        for (const Study& study : patient.studies) {
            all.insert(all.end(), study.series.begin(), study.series.end());
        }
    }
    return all;
}

const StudySeries* findUse(const std::vector<StudySeries>& all, SeriesUse use)
{
    const auto found = std::ranges::find(all, use, &StudySeries::use);
    return found == all.end() ? nullptr : &*found;
}

TEST(ReadStudies, FoldersOfSeriesAreReadTogetherAndNothingBesideThem)
{
    const TemporaryFolder folder;
    test::CtSlice slice = test::sliceOf(test::ctPhantom(), 0);
    for (const char* series : {"1.2.1", "1.2.2", "1.2.3"}) {
        slice.seriesUid = series;
        slice.sopInstanceUid = std::string(series) + ".1";
        folder.write(std::string(series) + "/1.dcm", test::ctSlice(slice));
    }

    const auto tree = readSeriesFolders({folder.file("1.2.1"), folder.file("1.2.3")});

    ASSERT_TRUE(tree);
    EXPECT_EQ(tree.value().readFiles, 2u);
    EXPECT_EQ(seriesOf(tree.value()).size(), 2u);
    EXPECT_FALSE(readSeriesFolders({folder.file("1.2.1"), folder.file("gone")}));
}

TEST(ReadStudies, AFolderBecomesPatientsStudiesAndSeries)
{
    const TemporaryFolder folder;
    test::writeDisc(folder);

    const StudyTree tree = read(folder.file(""), StudyScope::AllFiles);

    ASSERT_EQ(tree.patients.size(), 1u);
    EXPECT_EQ(tree.patients.front().identity.patientName, "Phantom^CT");
    ASSERT_EQ(tree.patients.front().studies.size(), 1u);
    const std::vector<StudySeries> all = seriesOf(tree);
    const StudySeries* vessels = findUse(all, SeriesUse::Vessels);
    ASSERT_TRUE(vessels);
    EXPECT_EQ(vessels->series.id, "1.2.3");
    EXPECT_EQ(vessels->imageCount, 10);
    EXPECT_EQ(vessels->place, folder.file("CT"));
    EXPECT_NEAR(vessels->series.stack.geometry.spacingMm.z(), test::ctPhantom().geometry.spacingMm.z(), 1e-9);
    const StudySeries* run = findUse(all, SeriesUse::View);
    ASSERT_TRUE(run);
    EXPECT_EQ(run->imageCount, 3);
    EXPECT_EQ(run->place, folder.file("XA/RUN1"));
    EXPECT_NEAR(run->frameTimeMs, 66.7, 0.1);
    const StudySeries* report = findUse(all, SeriesUse::None);
    ASSERT_TRUE(report);
    ASSERT_TRUE(report->reason);
    EXPECT_NE(report->reason->text().find("report"), std::string::npos);
    EXPECT_EQ(tree.otherFiles, 1u) << "the page of the viewer";
}

TEST(ReadStudies, OnlyHeadersAreRead)
{
    const TemporaryFolder folder;
    test::CtSlice slice = test::sliceOf(test::ctPhantom(), 0);
    slice.columns = slice.rows = 512;
    slice.pixels.assign(512 * 512, 0);
    const std::string path = folder.write("slice", test::ctSlice(slice));
    const auto whole = readStudyFile(path);
    ASSERT_TRUE(whole && whole.value());
    EXPECT_FALSE(whole.value()->images.damage);

    fs::resize_file(path, 300'000);   // of the 512 KiB of its pixels
    const auto cut = readStudyFile(path);

    ASSERT_TRUE(cut && cut.value());
    EXPECT_EQ(cut.value()->images.slices.size(), 1u);
    ASSERT_TRUE(cut.value()->images.damage) << "what is missing is known from the length alone";
}

TEST(ReadStudies, DamagedFilesAreNamedAndEndNothing)
{
    const TemporaryFolder folder;
    test::writeDisc(folder);
    folder.write("CT/EMPTY", "");
    folder.write("CT/TORN", std::string(128, '\0') + "DICM" + "\x08");

    const StudyTree tree = read(folder.file(""), StudyScope::AllFiles);

    ASSERT_EQ(tree.damagedFiles.size(), 2u);
    EXPECT_EQ(tree.damagedFiles[0].path, folder.file("CT/EMPTY"));
    EXPECT_EQ(tree.damagedFiles[1].path, folder.file("CT/TORN"));
    EXPECT_TRUE(findUse(seriesOf(tree), SeriesUse::Vessels));
}

TEST(ReadStudies, StopKeepsWhatWasFound)
{
    const TemporaryFolder folder;
    test::writeDisc(folder);
    const auto observe = [](const StudyProgress& progress) {
        return progress.read >= 4 ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    };

    const StudyTree tree = read(folder.file(""), StudyScope::AllFiles, observe);

    EXPECT_TRUE(tree.isStopped);
    EXPECT_EQ(tree.readFiles, 4u);
    ASSERT_EQ(seriesOf(tree).size(), 1u);
    EXPECT_EQ(seriesOf(tree).front().imageCount, 4);
}

TEST(ReadStudies, AScoutIsNoScan)
{
    const TemporaryFolder folder;
    test::writeDisc(folder);
    test::DicomBytes scout;
    scout.text(0x0008, 0x0008, "CS", "ORIGINAL\\PRIMARY\\LOCALIZER");
    test::CtSlice slice = test::sliceOf(test::ctPhantom(), 0);
    slice.seriesUid = "1.2.77";
    const std::string plain = test::ctSlice(slice);
    folder.write("SCOUT", plain.substr(0, 132) + scout.content() + plain.substr(132));

    const auto all = seriesOf(read(folder.file(""), StudyScope::AllFiles));

    const auto found = std::ranges::find(all, "1.2.77", [](const StudySeries& each) { return each.series.id; });
    ASSERT_NE(found, all.end());
    EXPECT_EQ(found->use, SeriesUse::None);
    EXPECT_NE(found->reason->text().find("scout"), std::string::npos);
}

TEST(DicomDirectory, ItsFilesAreReadAndThoseBesideItCounted)
{
    const TemporaryFolder folder;
    const std::vector<std::string> names = test::writeDisc(folder);
    test::writeDicomdir(folder.file(""), names);
    test::CtSlice other = test::sliceOf(test::ctPhantom(), 0);
    other.seriesUid = "1.2.55";
    for (int i = 0; i < 5; ++i) {
        other.sopInstanceUid = "1.2.55." + std::to_string(i);
        folder.write("MORE" + std::to_string(i), test::ctSlice(other));
    }

    for (const std::string& place : {folder.file(""), folder.file("DICOMDIR")}) {
        const StudyTree tree = read(place);
        ASSERT_TRUE(tree.directory);
        EXPECT_FALSE(tree.directory->damage);
        EXPECT_EQ(tree.directory->series, 3u);
        EXPECT_EQ(tree.directory->files, names.size());
        EXPECT_EQ(tree.directory->missingFiles, 0u);
        EXPECT_EQ(tree.directory->unlistedFiles, 5u);
        EXPECT_EQ(tree.readFiles, names.size());
        EXPECT_EQ(seriesOf(tree).size(), 3u);
    }
    EXPECT_EQ(seriesOf(read(folder.file(""), StudyScope::AllFiles)).size(), 4u);
}

TEST(DicomDirectory, MissingFilesAreReported)
{
    const TemporaryFolder folder;
    test::writeDicomdir(folder.file(""), test::writeDisc(folder));
    fs::remove_all(folder.file("XA"));
    fs::remove(folder.file("CT/IM3"));

    const StudyTree tree = read(folder.file(""));

    ASSERT_TRUE(tree.directory);
    EXPECT_EQ(tree.directory->missingFiles, 2u);
    const std::vector<StudySeries> all = seriesOf(tree);
    const StudySeries* vessels = findUse(all, SeriesUse::Vessels);
    ASSERT_TRUE(vessels);
    EXPECT_EQ(vessels->missingFiles, 1u);
    const auto gone = std::ranges::find_if(all, [](const StudySeries& each) { return each.series.slices.empty(); });
    ASSERT_NE(gone, all.end()) << "the run has no file left and is listed all the same";
    EXPECT_EQ(gone->use, SeriesUse::None);
    EXPECT_EQ(gone->series.identity.modality, "XA");
    EXPECT_NE(gone->reason->text().find("DICOMDIR"), std::string::npos);
}

TEST(DicomDirectory, NamesOfDiscsInOtherLettersAreFound)
{
    const TemporaryFolder folder;
    test::writeDicomdir(folder.file(""), test::writeDisc(folder));
    fs::rename(folder.file("CT"), folder.file("ct"));
    fs::rename(folder.file("ct/IM3"), folder.file("ct/im3.;1"));
    fs::rename(folder.file("DICOMDIR"), folder.file("dicomdir"));

    const StudyTree tree = read(folder.file(""));

    ASSERT_TRUE(tree.directory);
    EXPECT_EQ(tree.directory->missingFiles, 0u);
    EXPECT_EQ(findUse(seriesOf(tree), SeriesUse::Vessels)->imageCount, 10);
}

/// Whatever byte is wrong, the files are listed.
TEST(DicomDirectory, ADamagedOneIsReplacedByALookAtTheFiles)
{
    const TemporaryFolder folder;
    test::writeDicomdir(folder.file(""), test::writeDisc(folder));
    const std::string sound = test::readText(folder.file("DICOMDIR"));
    const std::string lower("\x04\x00\x20\x14UL\x04\x00", 8);   // an offset that then leads nowhere
    std::string torn = sound;
    torn[torn.find(lower) + lower.size()] ^= 0x5a;
    for (const std::string& content : {torn, sound.substr(0, sound.size() / 2), std::string("nothing")}) {
        folder.write("DICOMDIR", content);
        const StudyTree tree = read(folder.file(""));
        ASSERT_TRUE(tree.directory);
        ASSERT_TRUE(tree.directory->damage);
        EXPECT_EQ(seriesOf(tree).size(), 3u);
    }
}

TEST(DicomDirectory, NoMutantLosesTheFilesOrHangs)
{
    const TemporaryFolder folder;
    test::writeDicomdir(folder.file(""), test::writeDisc(folder));
    const std::string sound = test::readText(folder.file("DICOMDIR"));
    unsigned state = 12345;
    for (int trial = 0; trial < 200; ++trial) {
        std::string mutant = sound;
        for (int i = 0; i < 3; ++i) {
            state = state * 1664525U + 1013904223U;
            mutant[132 + state % (mutant.size() - 132)] = static_cast<char>(state >> 24);
        }
        const std::string path = folder.write("DICOMDIR", mutant);
        const auto files = readDicomDirectory(path);
        EXPECT_TRUE(!files || files.value().size() <= 100u);
    }
}

TEST(SeriesPicture, ShowsTheMiddleSliceAndTheMiddleFrame)
{
    const TemporaryFolder folder;
    test::writeDisc(folder);
    const std::vector<StudySeries> all = seriesOf(read(folder.file(""), StudyScope::AllFiles));

    const auto run = seriesThumbnail(findUse(all, SeriesUse::View)->series, 64);

    ASSERT_TRUE(run) << run.error().message.text();
    EXPECT_EQ(run.value().width, 64);
    // Frame 1 of three has its bright spot in the middle; the others have it elsewhere.
    EXPECT_FLOAT_EQ(run.value().at(32, 32), 1.0F);
    EXPECT_LT(run.value().at(8, 8), 0.5F);
    const auto slice = seriesThumbnail(findUse(all, SeriesUse::Vessels)->series, 64);
    ASSERT_TRUE(slice) << slice.error().message.text();
    EXPECT_EQ(slice.value().width, 8);
}

TEST(SeriesPicture, StopsWhenItIsNotWantedAnyMore)
{
    const TemporaryFolder folder;
    test::writeDisc(folder);
    const std::vector<StudySeries> all = seriesOf(read(folder.file(""), StudyScope::AllFiles));

    const auto picture =
        seriesThumbnail(findUse(all, SeriesUse::View)->series, 64, [](double) { return core::ObserverDecision::Stop; });

    EXPECT_TRUE(picture.isStopped());
}

TEST(ReadStudies, FilesOfManyVendorsAreListed)
{
    const std::string folder = std::string(TEST_DATA_DIR) + "/exotic-dicom/pydicom";
    if (!fs::exists(folder)) {
        GTEST_SKIP() << "no real DICOM files";
    }
    const StudyTree tree = read(folder);

    EXPECT_GT(tree.patients.size(), 5u);
    const std::vector<StudySeries> all = seriesOf(tree);
    EXPECT_TRUE(
        std::ranges::any_of(all, [](const StudySeries& each) { return each.series.identity.modality == "SR"; }));
    for (const StudySeries& each : all) {
        EXPECT_EQ(each.use == SeriesUse::None, each.reason.has_value()) << each.series.description;
        (void)seriesThumbnail(each.series, 96);   // or a reason, but no end of the program
    }
}

TEST(ReadStudies, ARealScanHasItsVolumeAndItsPicture)
{
    const std::string folder = std::string(TEST_DATA_DIR) + "/abdomen-ct/dicom-series-j2k";
    if (!fs::exists(folder)) {
        GTEST_SKIP() << "no real scan";
    }
    const StudyTree tree = read(folder);
    const std::vector<StudySeries> all = seriesOf(tree);
    const StudySeries* vessels = findUse(all, SeriesUse::Vessels);
    ASSERT_TRUE(vessels);
    const auto picture = seriesThumbnail(vessels->series, 96);
    ASSERT_TRUE(picture) << picture.error().message.text();
    EXPECT_LE(picture.value().width, 96);
    const auto [low, high] = std::ranges::minmax_element(picture.value().pixels);
    EXPECT_GT(*high - *low, 0.5F);
}

}   // namespace
}   // namespace angiopose::io
