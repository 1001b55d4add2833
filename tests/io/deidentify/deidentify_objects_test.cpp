#include "io/deidentify/content_cleaner.h"
#include "io/deidentify_file.h"
#include "io/deidentify_files.h"
#include "io/dicom/dicom_file.h"
#include "io/volume_file.h"
#include "tests/io/dicom/objects/made_objects.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <list>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;

/// Objects of a case with an identifier planted in its free-text fields, with the images that they reference.
class DeidentifyObjects : public test::MadeObjects {
protected:
    io::PresentationContent plantedState() const
    {
        io::PresentationContent shown = shownState();
        shown.layers[0].name = "PLANTED";
        shown.layers[0].description = "PLANTED layer";
        shown.layers[1].texts[0].words = "PLANTED on the image";
        shown.description = "PLANTED state";
        return shown;
    }

    io::MeasurementReport plantedMeasurements() const
    {
        io::MeasurementReport report = measured();
        report.groups[0].name = "PLANTED stenosis";
        report.groups[0].texts[0].words = "PLANTED comment";
        return report;
    }

    core::Result<io::DeidentifiedFiles> freed(const io::DeidentificationOptions& requested = {})
    {
        written("state", io::encodePresentationState(plantedState(), angiogram, origin));
        written("registration", io::encodeSpatialRegistration(registration(), angiogram, origin));
        written("segmentation", io::encodeVesselSegmentation(vessels(), "PLANTED algorithm", scan, origin));
        written("measurements", io::encodeMeasurementReport(plantedMeasurements(), angiogram, origin));
        auto done = io::deidentifyFiles({folder.file("")}, outPath(), requested, pseudonyms);
        EXPECT_TRUE(done) << done.error().message.text();
        return done;
    }

    std::string outPath() const { return output.file("out"); }
    void clear() const { fs::remove_all(outPath()); }

    std::vector<std::string> freedPaths() const
    {
        std::vector<std::string> paths;
        for (const auto& entry : fs::recursive_directory_iterator(outPath())) {
            if (entry.is_regular_file()) {
                paths.push_back(entry.path().string());
            }
        }
        return paths;
    }

    /// The only de-identified object of the given modality.
    io::DicomDataset freedOf(const std::string& modality)
    {
        for (const std::string& path : freedPaths()) {
            const std::string& content = contents.emplace_back(test::readText(path));
            auto file = io::parseDicom(content, path);
            if (file && file.value().dataset.text(0x00080060) == modality) {
                lastPath = path;
                return file.value().dataset;
            }
        }
        ADD_FAILURE() << "no " << modality;
        return {};
    }

    test::TemporaryFolder output;
    io::Pseudonyms pseudonyms{"a key of more than sixteen bytes"};
    std::list<std::string> contents;   ///< the bytes must outlive the data sets parsed from them
    std::string lastPath;
};

TEST_F(DeidentifyObjects, NothingPlantedIsLeft)
{
    for (const io::DatePolicy dates : {io::DatePolicy::None, io::DatePolicy::Shifted}) {
        const auto done = freed({.dates = dates});
        ASSERT_TRUE(done);
        EXPECT_TRUE(done.value().skipped.empty()) << done.value().skipped.front().text();
        ASSERT_EQ(freedPaths().size(), 10U) << "a run, five slices, four objects";
        for (const std::string& path : freedPaths()) {
            const std::string bytes = test::readText(path);
            for (const std::string secret :
                 {"PLANTED", "Müller", "Ünal", "P-17", "A-9", "Doe", "Jane", "19500301", "20240229", "20260504"}) {
                EXPECT_EQ(bytes.find(secret), std::string::npos) << secret << " in " << path;
            }
            EXPECT_EQ(bytes.find(angiogram.sopInstanceUid), std::string::npos) << path;
            EXPECT_EQ(bytes.find(angiogram.studyUid), std::string::npos) << path;
        }
        clear();
    }
}

TEST_F(DeidentifyObjects, SaysThatWordsWereTakenOut)
{
    const auto done = freed();
    ASSERT_TRUE(done);
    EXPECT_TRUE(std::ranges::any_of(done.value().warnings, [](const core::Message& message) {
        return message.id() == "deidentify.words-cleared";
    }));
}

/// UIDs are consistent across all files of the case, so that references still resolve.
TEST_F(DeidentifyObjects, ReferencesStillResolve)
{
    ASSERT_TRUE(freed());
    const io::DicomDataset run = freedOf("XA");
    const std::string image(run.text(0x00080018)), series(run.text(0x0020000e)), study(run.text(0x0020000d));
    EXPECT_EQ(image, pseudonyms.uid(angiogram.sopInstanceUid));
    for (const char* modality : {"PR", "REG", "SR"}) {
        EXPECT_EQ(freedOf(modality).text(0x0020000d), study) << modality;
    }
    const auto isOfRun = [&](const io::DicomDataset& referred, io::DicomTag images) {
        return referred.text(0x0020000e) == series && referred.items(images).front().text(0x00081155) == image;
    };
    const io::DicomDataset state = freedOf("PR");
    EXPECT_TRUE(isOfRun(state.items(0x00081115).front(), 0x00081140));
    EXPECT_EQ(state.items(0x00700001).front().items(0x00081140).front().text(0x00081155), image);
    EXPECT_TRUE(isOfRun(freedOf("REG").items(0x00081115).front(), 0x0008114a));
    const io::DicomDataset report = freedOf("SR");
    EXPECT_TRUE(isOfRun(report.items(0x0040a375).front().items(0x00081115).front(), 0x00081199));
    const io::DicomDataset segmentation = freedOf("SEG");
    const std::vector<io::DicomDataset> frames = segmentation.items(0x52009230);
    ASSERT_EQ(frames.size(), 5U);
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const io::DicomDataset derived = frames[k].items(0x00089124).front();
        EXPECT_EQ(derived.items(0x00082112).front().text(0x00081155), pseudonyms.uid("1.2.3." + std::to_string(k + 1)));
        EXPECT_EQ(derived.items(0x00089215).front().text(0x00080104), "Segmentation");
    }
    const auto spaceOf = [&](const io::DicomDataset& item) { return item.text(0x00200052); };
    EXPECT_EQ(spaceOf(segmentation), pseudonyms.uid(io::scanFrameOfReference(scan.source, origin.uidFor("scan"))));
    EXPECT_EQ(spaceOf(freedOf("REG").items(0x00700308).front()), pseudonyms.uid("1.2.3.4"));
}

TEST_F(DeidentifyObjects, SegmentationKeepsEveryVoxelAndPlace)
{
    ASSERT_TRUE(freed());
    const io::DicomDataset data = freedOf("SEG");
    const auto labels = io::readLabels(lastPath);
    ASSERT_TRUE(labels) << labels.error().message;
    const core::VoxelMask mask = vessels();
    EXPECT_TRUE(std::ranges::equal(labels.value().voxels, mask.voxels));
    EXPECT_LE((labels.value().geometry.patientFromVoxel().matrix() - mask.geometry.patientFromVoxel().matrix())
                  .cwiseAbs()
                  .maxCoeff(),
              1e-9);
    const io::DicomDataset segment = data.items(0x00620002).front();
    EXPECT_EQ(segment.text(0x00620005), "Arteries");
    EXPECT_EQ(segment.items(0x0062000f).front().text(0x00080104), "Artery");
}

/// Of 7 · 9 · 5 voxels of one bit the last byte has five bits that nobody sees.
TEST_F(DeidentifyObjects, BitsBehindTheLastVoxelAreCleared)
{
    core::VoxelMask odd = vessels();
    odd.geometry.size = {7, 9, 5};
    odd.voxels.assign(315, 1);
    const std::string path = written("odd", io::encodeVesselSegmentation(odd, "drawn", scan, origin));
    std::string bytes = test::readText(path);
    bytes.back() = static_cast<char>(0xff);
    folder.write("odd-object.dcm", bytes);
    ASSERT_TRUE(io::deidentifyFile(path, folder.file("odd-freed.dcm"), {}, pseudonyms));
    const std::string freedBytes = test::readText(folder.file("odd-freed.dcm"));
    const auto file = io::parseDicom(freedBytes, "odd");
    ASSERT_TRUE(file);
    const std::string_view voxels = file.value().pixels.at(io::pixelDataTag).bytes;
    ASSERT_EQ(voxels.size(), 40U);
    EXPECT_EQ(static_cast<unsigned char>(voxels.back()), 0x07U);
}

TEST_F(DeidentifyObjects, StateKeepsLinesAndRegistrationItsMatrix)
{
    ASSERT_TRUE(freed());
    const io::DicomDataset state = freedOf("PR");
    const io::DicomDataset annotation = state.items(0x00700001).front();
    const io::DicomDataset line = annotation.items(0x00700009).front();
    EXPECT_EQ(line.number(0x00700022, 2), 3.75);
    EXPECT_EQ(line.number(0x00700022, 5), 15.5);
    std::vector<std::string> layers;
    for (const io::DicomDataset& layer : state.items(0x00700060)) {
        layers.emplace_back(layer.text(0x00700002));
    }
    EXPECT_NE(std::ranges::find(layers, annotation.text(0x00700002)), layers.end()) << "the layer it lies on";
    const std::string regPath = [&] {
        (void)freedOf("REG");
        return lastPath;
    }();
    const auto read = io::readSpatialRegistration(test::readText(regPath), regPath);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_LE((read.value().matrix() - pose().matrix()).cwiseAbs().maxCoeff(), 1e-9);
}

/// Names, dates and terms of a report that others wrote; items stay where they are, since others refer to their places.
TEST_F(DeidentifyObjects, ForeignReportKeepsItsTreeWithoutWords)
{
    io::DicomObject object;
    io::DicomItem root = object.root();
    root.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.88.33");
    root.text(0x00080018, "UI", "1.2.3.777.1");
    root.text(0x00080060, "CS", "SR");
    root.text(0x00100010, "PN", "Doe^Jane");
    root.text(0x00100020, "LO", "4711815");
    root.text(0x0040a493, "CS", "VERIFIED");
    root.addItem(0x0040a073).text(0x0040a075, "PN", "PLANTED^Doctor");
    const auto add = [&root](const char* type, const io::CodedTerm& meaning) {
        io::DicomItem item = root.addItem(0x0040a730);
        item.text(0x0040a010, "CS", "CONTAINS");
        item.text(0x0040a040, "CS", type);
        io::addTerm(item, 0x0040a043, meaning);
        return item;
    };
    add("PNAME", {"121008", "DCM", "PLANTED meaning"}).text(0x0040a123, "PN", "PLANTED^Observer");
    add("DATE", {"111018", "DCM", "Content Date"}).text(0x0040a121, "DA", "20250314");
    add("TEXT", {"PLANTED1", "99LOCAL", "PLANTED term"}).text(0x0040a160, "UT", "PLANTED words");
    io::DicomItem code = add("CODE", {"4711815", "SCT", "the ID as a code"});
    io::addTerm(code, 0x0040a168, {"PLANTED", "UCUM", "a unit that is none"});
    add("UIDREF", {"112040", "DCM", "UID"}).text(0x0040a124, "UI", "1.2.3.777.2");
    const auto content = object.content();
    ASSERT_TRUE(content);
    folder.write("foreign.dcm", content.value());
    ASSERT_TRUE(io::deidentifyFile(folder.file("foreign.dcm"), folder.file("foreign-freed.dcm"), {}, pseudonyms));
    const std::string bytes = test::readText(folder.file("foreign-freed.dcm"));
    for (const char* secret : {"PLANTED", "Doe", "4711", "1.2.3.777", "20250314"}) {
        EXPECT_EQ(bytes.find(secret), std::string::npos) << secret;
    }
    const auto file = io::parseDicom(bytes, "foreign");
    ASSERT_TRUE(file);
    const std::vector<io::DicomDataset> items = file.value().dataset.items(0x0040a730);
    ASSERT_EQ(items.size(), 5U);
    EXPECT_EQ(items[0].items(0x0040a043).front().text(0x00080100), "121008") << "a public code stays";
    EXPECT_EQ(items[1].text(0x0040a121), "19000101");
    EXPECT_EQ(items[4].text(0x0040a124), pseudonyms.uid("1.2.3.777.2"));
    EXPECT_EQ(file.value().dataset.text(0x0040a493), "UNVERIFIED") << "nobody is named who did";
}

TEST_F(DeidentifyObjects, OwnTermsKeepTheirMeaning)
{
    std::size_t terms = 0;
    const io::IdentityWords none{io::DicomDataset()};
    const std::function<void(const io::DicomDataset&)> look = [&](const io::DicomDataset& data) {
        for (const io::DicomDataset& item : data.itemsOfAllSequences()) {
            if (item.has(0x00080100)) {
                const io::CodedEntry read{std::string(item.text(0x00080100)), std::string(item.text(0x00080102)),
                                          std::string(item.text(0x00080104))};
                const io::DeidentifiedTerm kept = io::deidentifyTerm(read, none);
                EXPECT_FALSE(kept.isReplaced) << read.meaning;
                EXPECT_EQ(kept.term.meaning, read.meaning);
                ++terms;
            }
            look(item);
        }
    };
    for (const auto& [name, object] : all()) {
        ASSERT_TRUE(object) << name;
        const auto file = io::parseDicom(object.value(), name);
        ASSERT_TRUE(file);
        look(file.value().dataset);
    }
    EXPECT_GT(terms, 30U);
}

TEST_F(DeidentifyObjects, PagesAndUnknownKindsAreRefusedWithASentence)
{
    const std::string path = written(
        "report",
        io::encodeEncapsulatedPdf("%PDF-1.4\nodd", "Report", io::BurnedInIdentity::Possible, angiogram, origin));
    const auto done = io::deidentifyFile(path, folder.file("pdf-freed.dcm"), {}, pseudonyms);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().message.id(), "deidentify.pages");
    EXPECT_FALSE(fs::exists(folder.file("pdf-freed.dcm")));
    io::DicomObject object;
    object.root().text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66");
    object.root().text(0x00080018, "UI", "1.2.3");
    folder.write("raw.dcm", object.content().value());
    const auto raw = io::deidentifyFile(folder.file("raw.dcm"), folder.file("raw-freed.dcm"), {}, pseudonyms);
    ASSERT_FALSE(raw);
    EXPECT_EQ(raw.error().message.id(), "deidentify.object");
}

TEST_F(DeidentifyObjects, ThatHoldPixelsTheirClassDoesNotHaveAreRefused)
{
    const std::string pixels(16, 7);
    for (const char* classUid : {"11.1", "66.1", "88.33"}) {
        io::DicomObject object;
        object.root().text(0x00080016, "UI", std::string("1.2.840.10008.5.1.4.1.1.") + classUid);
        object.root().text(0x00080018, "UI", "1.2.3");
        object.root().bytes(0x7fe00010, pixels);
        folder.write("odd.dcm", object.content().value());
        const auto done = io::deidentifyFile(folder.file("odd.dcm"), folder.file("odd-freed.dcm"), {}, pseudonyms);
        ASSERT_FALSE(done) << classUid;
        EXPECT_EQ(done.error().message.id(), "deidentify.object-with-pixels");
        EXPECT_FALSE(fs::exists(folder.file("odd-freed.dcm")));
    }
}

TEST_F(DeidentifyObjects, OtherToolsFindNoErrorInThem)
{
    if (std::system("command -v dciodvfy > /dev/null 2>&1") != 0) {
        GTEST_SKIP() << "dciodvfy (package dicom3tools) is not there";
    }
    for (const io::DatePolicy dates : {io::DatePolicy::None, io::DatePolicy::Shifted}) {
        ASSERT_TRUE(freed({.dates = dates}));
        for (const char* modality : {"PR", "REG", "SEG", "SR"}) {
            (void)freedOf(modality);
            const std::string log = folder.file("log");
            (void)std::system(("dciodvfy -new '" + lastPath + "' > '" + log + "' 2>&1").c_str());
            const std::string said = test::readText(log);
            EXPECT_EQ(said.find("Error"), std::string::npos) << modality << '\n' << said;
        }
        clear();
    }
}

}   // namespace
