#include "tests/io/deidentify/planted_run.h"

#include "io/angiogram_file.h"
#include "io/deidentify/remove_image_metadata.h"
#include "io/deidentify_file.h"
#include "io/dicom/dicom_file.h"
#include "io/image_file.h"
#include "tests/support/drawn_letters.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cstdlib>
#include <filesystem>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;

constexpr std::size_t pixelsPerFrame = std::size_t{test::PlantedRun::columns} * test::PlantedRun::rows;

class Deidentify : public ::testing::Test {
protected:
    Deidentify()
    {
        for (std::size_t n = 0; n < pixels.size(); ++n) {
            pixels[n] = static_cast<std::int16_t>(n * 37 % 4096);
        }
        folder.write("DOE_JANE_4711/run.dcm", planted.content(pixels));
    }

    core::Messages freed(const io::DeidentificationOptions& requested = {})
    {
        const auto done = io::deidentifyFile(in(), out(), requested, pseudonyms);
        EXPECT_TRUE(done) << done.error().message.text();
        return done ? done.value() : core::Messages{};
    }

    io::DicomFile parsed()
    {
        content = test::readText(out());
        auto file = io::parseDicom(content, out());
        EXPECT_TRUE(file);
        return std::move(file).value();
    }

    std::string in() const { return folder.file("DOE_JANE_4711/run.dcm"); }
    std::string out() const { return folder.file("out.dcm"); }

    test::TemporaryFolder folder;
    test::PlantedRun planted;
    std::vector<std::int16_t> pixels = std::vector<std::int16_t>(2 * pixelsPerFrame);
    io::Pseudonyms pseudonyms{"a key of more than sixteen bytes"};
    std::string content;
};

TEST_F(Deidentify, LeavesNothingOfSixtyPlantedIdentifiers)
{
    ASSERT_GT(planted.count(), 60);
    for (const io::DatePolicy dates : {io::DatePolicy::None, io::DatePolicy::Shifted}) {
        freed({.dates = dates});
        const std::string bytes = test::readText(out());
        for (const char* secret :
             {"PLANTED", "JANE", "4711", "1.2.3.777", "20250314", "20250315", "19500102", "1.2.3.4"}) {
            EXPECT_EQ(bytes.find(secret), std::string::npos) << secret;
        }
    }
}

TEST_F(Deidentify, KeepsWhatDescribesTheImage)
{
    freed();
    const io::DicomFile file = parsed();
    EXPECT_EQ(file.dataset.text(0x00080070), "Maker of arms");
    EXPECT_EQ(file.dataset.number(0x00181110), 1000.0);
    EXPECT_EQ(file.dataset.number(0x00181510), -30.5);
    EXPECT_EQ(file.dataset.number(0x00181164, 1), 0.2);
    EXPECT_EQ(file.dataset.text(0x00200020), "L\\F");
    EXPECT_EQ(file.dataset.integer(0x00200013), 7);
    ASSERT_EQ(file.dataset.items(0x00286100).size(), 1U);
    EXPECT_EQ(file.dataset.items(0x00286100)[0].text(0x00286101), "AVG_SUB");
    const auto run = io::readAngiogram(out());
    ASSERT_TRUE(run) << run.error().message.text();
    ASSERT_EQ(run.value().frameCount(), 2);
    for (std::size_t n = 0; n < pixels.size(); ++n) {
        const core::ImageF& frame = run.value().frames[n / pixelsPerFrame];
        ASSERT_EQ(frame.pixels[n % pixelsPerFrame], static_cast<float>(pixels[n])) << n;
    }
}

TEST_F(Deidentify, SaysWhatWasDone)
{
    freed({.dates = io::DatePolicy::Shifted, .letters = io::BurnedInTextPolicy::Masked});
    const io::DicomFile file = parsed();
    EXPECT_EQ(file.dataset.text(0x00120062), "YES");
    EXPECT_EQ(file.dataset.text(0x00280303), "MODIFIED");
    std::vector<std::string> codes;
    for (const io::DicomDataset& item : file.dataset.items(0x00120064)) {
        codes.emplace_back(item.text(0x00080100));
    }
    for (const char* code : {"113100", "113101", "113103", "113107"}) {
        EXPECT_NE(std::ranges::find(codes, code), codes.end()) << code;
    }
}

TEST_F(Deidentify, MapsUidsAndDatesTheSameForAllFiles)
{
    freed({.dates = io::DatePolicy::Shifted});
    const io::DicomFile file = parsed();
    EXPECT_EQ(file.dataset.text(0x0020000d), pseudonyms.uid("1.2.3.777.13"));
    EXPECT_EQ(file.dataset.text(0x00100010), pseudonyms.patient("4711-0815"));
    EXPECT_EQ(file.dataset.text(0x00080016), "1.2.840.10008.5.1.4.1.1.12.1");
    ASSERT_EQ(file.dataset.items(0x00081140).size(), 1U);
    EXPECT_EQ(file.dataset.items(0x00081140)[0].text(0x00081155), pseudonyms.uid("1.2.3.777.1140"));
    const std::string study(file.dataset.text(0x00080020));
    EXPECT_EQ(study, pseudonyms.date("20250314", "4711-0815"));
    EXPECT_LT(study, "20250101");
    EXPECT_EQ(file.dataset.text(0x0008002a).substr(8), "101112.5");
    EXPECT_NE(io::Pseudonyms("another key of sixteen bytes").uid("1.2.3"), pseudonyms.uid("1.2.3"));
    EXPECT_NE(pseudonyms.patient("4711"), pseudonyms.patient("4712"));
    EXPECT_EQ(pseudonyms.date("20250230", "x"), "");
    EXPECT_EQ(pseudonyms.date("DOE", "x"), "");
}

TEST_F(Deidentify, TellsOfLettersOrBlacksThemOut)
{
    core::ImageF letters(test::PlantedRun::columns, test::PlantedRun::rows, 1000.0F);
    test::writeLetters(letters, {16, 10}, 7, 4095.0F);
    for (std::size_t n = 0; n < pixels.size(); ++n) {
        pixels[n] = static_cast<std::int16_t>(letters.pixels[n % pixelsPerFrame]);
    }
    folder.write("DOE_JANE_4711/run.dcm", test::PlantedRun().content(pixels));
    const core::Messages reported = freed();
    ASSERT_EQ(reported.size(), 1U);
    EXPECT_EQ(reported[0].id(), "deidentify.letters-stay");
    EXPECT_EQ(parsed().dataset.text(0x00280301), "YES");
    const core::Messages blackened = freed({.letters = io::BurnedInTextPolicy::Masked});
    ASSERT_EQ(blackened.size(), 1U);
    EXPECT_EQ(blackened[0].id(), "deidentify.letters-blacked-out");
    const auto run = io::readAngiogram(out());
    ASSERT_TRUE(run);
    EXPECT_EQ(*std::ranges::max_element(run.value().frames[1].pixels), 1000.0F);
    EXPECT_EQ(run.value().frames[0].at(200, 150), 1000.0F);
}

TEST_F(Deidentify, LettersAsHighAsASeventhAreBlackedOut)
{
    core::ImageF letters(test::PlantedRun::columns, test::PlantedRun::rows, 1000.0F);
    test::writeLetters(letters, {16, 10}, 4, 4095.0F, 5);   // 35 of 256 px
    for (std::size_t n = 0; n < pixels.size(); ++n) {
        pixels[n] = static_cast<std::int16_t>(letters.pixels[n % pixelsPerFrame]);
    }
    folder.write("DOE_JANE_4711/run.dcm", test::PlantedRun().content(pixels));
    const core::Messages blackened = freed({.letters = io::BurnedInTextPolicy::Masked});
    ASSERT_EQ(blackened.size(), 1U);
    EXPECT_EQ(blackened[0].id(), "deidentify.letters-blacked-out");
    const auto run = io::readAngiogram(out());
    ASSERT_TRUE(run);
    EXPECT_EQ(*std::ranges::max_element(run.value().frames[0].pixels), 1000.0F);
}

TEST_F(Deidentify, FolderBecomesSeriesWithNeutralNames)
{
    for (int k = 0; k < 3; ++k) {
        test::CtSlice slice;
        slice.sopInstanceUid = "1.2.3.777.9" + std::to_string(k);
        slice.patientName = "DOE^JANE";
        slice.position = {0, 0, 2.0 * k};
        slice.pixels.assign(72, static_cast<std::int16_t>(100 * k));
        folder.write("DOE_JANE_4711/ct/" + std::to_string(k) + ".dcm", test::ctSlice(slice));
    }
    folder.write("DOE_JANE_4711/letter.txt", "Dear Jane Doe");
    const auto done = io::deidentifyFolder(folder.file("DOE_JANE_4711"), folder.file("out"), {}, pseudonyms);
    ASSERT_TRUE(done) << done.error().message.text();
    EXPECT_TRUE(std::ranges::any_of(
        done.value(), [](const core::Message& message) { return message.id() == "deidentify.files-left-out"; }));
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder.file("out"))) {
        if (entry.is_regular_file()) {
            names.push_back(entry.path().lexically_relative(folder.file("out")).string());
            EXPECT_EQ(test::readText(entry.path()).find("DOE"), std::string::npos);
        }
    }
    std::ranges::sort(names);
    EXPECT_EQ(names, (std::vector<std::string>{"series-1/00001.dcm", "series-1/00002.dcm", "series-1/00003.dcm",
                                               "series-2/00001.dcm"}));
    const auto again = io::deidentifyFolder(folder.file("DOE_JANE_4711"), folder.file("out"), {}, pseudonyms);
    ASSERT_FALSE(again);   // no files from another source are mixed in
    EXPECT_EQ(again.error().message.id(), "deidentify.output-not-empty");
}

TEST_F(Deidentify, FilesWithoutUidsStayApart)
{
    for (int k = 0; k < 2; ++k) {
        test::CtSlice slice;
        slice.seriesUid = "";
        slice.position = {0, 0, 2.0 * k};
        slice.pixels.assign(72, 7);
        folder.write("bare/" + std::to_string(k) + ".dcm", test::ctSlice(slice));
    }
    ASSERT_TRUE(io::deidentifyFolder(folder.file("bare"), folder.file("out"), {}, pseudonyms));
    std::vector<std::string> instances;
    std::vector<std::string> series;
    for (const char* name : {"out/series-1/00001.dcm", "out/series-1/00002.dcm"}) {
        const std::string bytes = test::readText(folder.file(name));
        const auto file = io::parseDicom(bytes, name);
        ASSERT_TRUE(file) << name;
        instances.emplace_back(file.value().dataset.text(0x00080018));
        series.emplace_back(file.value().dataset.text(0x0020000e));
    }
    EXPECT_NE(instances[0], instances[1]);
    EXPECT_EQ(series[0], series[1]);
    EXPECT_NE(series[0], instances[0]);
}

TEST_F(Deidentify, StoppedFolderLeavesNothing)
{
    const auto done = io::deidentifyFolder(folder.file("DOE_JANE_4711"), folder.file("out"), {}, pseudonyms,
                                           [](double) { return core::ObserverDecision::Stop; });
    EXPECT_TRUE(done.isStopped());
    EXPECT_FALSE(fs::exists(folder.file("out")));
}

TEST_F(Deidentify, PicturesLoseWhatIsWrittenBesideThePixels)
{
    core::ColorImage picture{16, 12, std::vector<std::uint8_t>(16 * 12 * 3, 90)};
    ASSERT_TRUE(io::writePng(picture, folder.file("a.png"), {{"Patient", "PLANTED"}}));
    const std::string png = test::readText(folder.file("a.png")) + "PLANTED behind the end";
    const auto stripped = io::removeImageMetadata(png, "a.png");
    ASSERT_TRUE(stripped);
    EXPECT_EQ(stripped.value().find("PLANTED"), std::string::npos);
    folder.write("b.png", stripped.value());
    const auto before = io::readAngiogram(folder.file("a.png"));
    const auto after = io::readAngiogram(folder.file("b.png"));
    ASSERT_TRUE(before && after);
    EXPECT_EQ(before.value().frames[0].pixels, after.value().frames[0].pixels);

    const std::string comment("\xff\xfe\x00\x09PLANTED", 11);
    const std::string exif("\xff\xe1\x00\x09PLANTED", 11);
    const std::string scan("\xff\xda\x00\x04\x01\x02\x11\xff\x00\x22\xff\xd0\x33", 13);
    const std::string table("\xff\xdb\x00\x04\x01\x02", 6);
    const auto jpeg = io::removeImageMetadata("\xff\xd8" + exif + table + comment + scan + "\xff\xd9PLANTED", "a.jpg");
    ASSERT_TRUE(jpeg);
    EXPECT_EQ(jpeg.value(), "\xff\xd8" + table + scan + "\xff\xd9");
    EXPECT_FALSE(io::removeImageMetadata("\xff\xd8" + exif, "a.jpg"));
    EXPECT_FALSE(io::removeImageMetadata("GIF89a", "a.gif"));
}

TEST_F(Deidentify, OtherToolsFindNoErrorInIt)
{
    if (std::system("command -v dciodvfy > /dev/null 2>&1") != 0) {
        GTEST_SKIP() << "dciodvfy (package dicom3tools) is not there";
    }
    core::Angiogram run;
    run.frames.assign(2, core::ImageF(64, 48, 100.0F));
    run.frameTimeMs = 66.6;
    run.cArm.primaryAngleDeg.value = -30.5;
    run.cArm.secondaryAngleDeg.value = 10.0;
    run.identity.patientName = "DOE^JANE";
    run.identity.laterality = "L";
    ASSERT_TRUE(io::writeAngiogram(run, in()));
    freed();
    const std::string log = folder.file("log");
    (void)std::system(("dciodvfy '" + out() + "' > '" + log + "' 2>&1").c_str());
    const std::string said = test::readText(log);
    EXPECT_EQ(said.find("Error"), std::string::npos) << said;
}

TEST_F(Deidentify, RealRunsKeepEveryPixel)
{
    const fs::path data = test::dataFile("coronary-phantom-xa");
    if (!fs::exists(data)) {
        GTEST_SKIP() << "no real run at " << data;
    }
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(data)) {
        if (!entry.is_regular_file() || !io::isDicomFile(entry.path().string())) {
            continue;
        }
        const auto before = io::readAngiogram(entry.path().string());
        const auto done = io::deidentifyFile(entry.path().string(), out(), {}, pseudonyms);
        if (!before) {
            continue;
        }
        ASSERT_TRUE(done) << entry.path() << done.error().message.text();
        const auto after = io::readAngiogram(out());
        ASSERT_TRUE(after) << entry.path();
        ASSERT_EQ(before.value().frameCount(), after.value().frameCount());
        for (int k = 0; k < before.value().frameCount(); ++k) {
            EXPECT_EQ(before.value().frames[static_cast<std::size_t>(k)].pixels,
                      after.value().frames[static_cast<std::size_t>(k)].pixels);
        }
        EXPECT_EQ(before.value().cArm.primaryAngleDeg.value, after.value().cArm.primaryAngleDeg.value);
        EXPECT_EQ(before.value().cArm.sourceToDetectorMm.value, after.value().cArm.sourceToDetectorMm.value);
        EXPECT_EQ(before.value().polarity, after.value().polarity);
        ++count;
    }
    EXPECT_GT(count, 0);
}

}   // namespace
