#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_text.h"
#include "io/dicom/new_uid.h"
#include "io/pose_file.h"
#include "io/volume_file.h"
#include "tests/io/dicom/objects/made_objects.h"

#include <algorithm>
#include <set>

using namespace angiopose;

namespace {

using test::MadeObjects;

/// The object parsed by this program's own reader; the bytes must outlive it.
io::DicomFile parsedObject(const std::string& content)
{
    auto file = io::parseDicom(content, "object");
    EXPECT_TRUE(file) << file.error().message;
    return file ? std::move(file).value() : io::DicomFile{};
}

TEST_F(MadeObjects, BelongToThePatientAndStudyOfTheirImage)
{
    for (const auto& [name, object] : all()) {
        ASSERT_TRUE(object) << name << ": " << object.error().message;
        const io::DicomDataset data = parsedObject(object.value()).dataset;
        const bool isScanPatient = name == "segmentation";
        EXPECT_EQ(data.text(0x0020000d), isScanPatient ? "1.2" : angiogram.studyUid) << name;
        EXPECT_EQ(io::utf8Text(data, 0x00100010), isScanPatient ? "Phantom^CT" : "Müller^Ünal") << name;
        EXPECT_EQ(data.text(0x00080005), "ISO_IR 192") << name;
        EXPECT_EQ(data.text(0x00189004), "RESEARCH") << name;
        EXPECT_NE(data.text(0x00400280).find("not a medical device"), std::string_view::npos) << name;
        if (!isScanPatient) {
            EXPECT_EQ(data.text(0x00100020), "P-17") << name;
            EXPECT_EQ(data.text(0x00100030), "19500301") << name;
            EXPECT_EQ(data.text(0x00080050), "A-9") << name;
            EXPECT_EQ(data.text(0x00080020), "20240229") << name;
        }
    }
}

TEST_F(MadeObjects, HaveUidsThatNobodyHas)
{
    std::set<std::string> known{angiogram.seriesUid, angiogram.sopInstanceUid, "1.2.3"};
    for (const auto& [name, object] : all()) {
        const io::DicomDataset data = parsedObject(object.value()).dataset;
        for (const io::DicomTag tag : {0x00080018U, 0x0020000eU}) {
            const std::string uid(data.text(tag));
            EXPECT_TRUE(known.insert(uid).second) << name << ": " << uid;
            EXPECT_EQ(uid.substr(0, 5), "2.25.") << name;
            EXPECT_NE(uid[5], '0') << name;
            EXPECT_LE(uid.size(), 44U) << name;
        }
    }
}

TEST_F(MadeObjects, AreTheSameBytesForTheSameOrigin)
{
    const auto first = all(), again = all();
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].second.value(), again[i].second.value()) << first[i].first;
    }
}

TEST(NewUid, IsAnotherOneEveryTimeAndFollowsFromContent)
{
    std::set<std::string> uids;
    for (int i = 0; i < 1000; ++i) {
        EXPECT_TRUE(uids.insert(io::makeUid()).second);
    }
    EXPECT_EQ(io::uidFromContent("a"), io::uidFromContent("a"));
    EXPECT_NE(io::uidFromContent("a"), io::uidFromContent("b"));
    // SHA-256 of "a" is ca978112ca1bbdcafac231b39a23dc4d…, with version 8 and variant bits ca978112-ca1b-8dca-bac2-…
    EXPECT_EQ(io::uidFromContent("a"), "2.25.269290709893686844195134956664967650381");
}

TEST(NewUid, TellsUidsFromOtherWords)
{
    for (const char* good : {"1", "1.2.840.10008.1.2", "2.25.0", "0.1"}) {
        EXPECT_TRUE(io::isUid(good)) << good;
        EXPECT_EQ(io::validUid(good), good);
    }
    for (const char* bad : {"", ".", "1.", ".1", "1..2", "1.02", "dccc95", "1.2 ", "1,2"}) {
        EXPECT_FALSE(io::isUid(bad)) << bad;
        EXPECT_TRUE(io::isUid(io::validUid(bad))) << bad;
    }
    EXPECT_FALSE(io::isUid("1." + std::string(63, '2')));
}

TEST_F(MadeObjects, WithoutADicomImageAreAStudyOfTheirOwn)
{
    folder.write("plain.png", "\x89PNG\r\n\x1a\n no image");
    const io::SourceImage plain = source(folder.file("plain.png"));
    EXPECT_FALSE(plain.isDicom);
    const auto object = io::encodeSecondaryCapture(images(1), plain, origin);
    ASSERT_TRUE(object);
    const io::DicomDataset data = parsedObject(object.value()).dataset;
    EXPECT_EQ(data.text(0x0020000d), origin.uidFor("study"));
    EXPECT_TRUE(data.has(0x00100010));
    EXPECT_EQ(data.text(0x00100010), "");
    EXPECT_FALSE(data.has(0x00082112));
    const auto state = io::encodePresentationState(shownState(), plain, origin);
    ASSERT_FALSE(state);
    EXPECT_EQ(state.error().message.id(), "object.no-reference");
}

TEST_F(MadeObjects, PicturesKeepEveryByte)
{
    for (const int count : {1, 3}) {
        const io::CapturedImages capture = images(count);
        const auto object = count == 1 ? io::encodeSecondaryCapture(capture, angiogram, origin)
                                       : io::encodeMultiframeCapture(capture, angiogram, origin);
        ASSERT_TRUE(object);
        const io::DicomFile file = parsedObject(object.value());
        EXPECT_EQ(file.dataset.text(0x00280004), "RGB");
        EXPECT_EQ(file.dataset.integer(0x00280008).value_or(1), count);
        EXPECT_EQ(file.dataset.text(0x00280301), "YES");
        EXPECT_EQ(file.dataset.items(0x00082112).front().text(0x00081155), angiogram.sopInstanceUid);
        std::string expected;
        for (const core::ColorImage& picture : capture.images) {
            expected.append(picture.rgb.begin(), picture.rgb.end());
        }
        EXPECT_EQ(file.pixels.at(io::pixelDataTag).bytes.substr(0, expected.size()), expected);
    }
}

TEST_F(MadeObjects, PicturesOfSeveralSizesAreRefused)
{
    io::CapturedImages capture = images(2);
    capture.images[1] = core::ColorImage{2, 2, std::vector<std::uint8_t>(12)};
    EXPECT_FALSE(io::encodeMultiframeCapture(capture, angiogram, origin));
    EXPECT_FALSE(io::encodeSecondaryCapture({}, angiogram, origin));
}

TEST_F(MadeObjects, ReportsAreWrappedAsTheyAre)
{
    const std::string pdf = "%PDF-1.4\nodd";
    const auto object = io::encodeEncapsulatedPdf(pdf, "Title", io::BurnedInIdentity::None, angiogram, origin);
    ASSERT_TRUE(object);
    EXPECT_NE(object.value().find(pdf), std::string::npos);
    EXPECT_EQ(parsedObject(object.value()).dataset.integer(0x00420015), static_cast<int>(pdf.size()));
    EXPECT_FALSE(io::encodeEncapsulatedPdf("<html>", "Title", io::BurnedInIdentity::None, angiogram, origin));
}

/// The transform maps patient points of the scan to camera points, a direction that other programs have often inverted.
TEST_F(MadeObjects, RegistrationTakesPatientPointsToCameraPoints)
{
    const auto object = io::encodeSpatialRegistration(registration(), angiogram, origin);
    ASSERT_TRUE(object);
    const io::DicomDataset data = parsedObject(object.value()).dataset;
    EXPECT_EQ(data.text(0x00200052), registration().cameraFrameOfReferenceUid);
    const std::vector<io::DicomDataset> items = data.items(0x00700308);
    ASSERT_EQ(items.size(), 2U);
    EXPECT_EQ(items[0].text(0x00200052), "1.2.3.4");
    EXPECT_EQ(items[1].text(0x00200052), data.text(0x00200052));
    EXPECT_EQ(items[1].items(0x00081140).front().text(0x00081155), angiogram.sopInstanceUid);
    const auto matrixOf = [](const io::DicomDataset& item) {
        const io::DicomDataset step = item.items(0x00700309).front().items(0x0070030a).front();
        EXPECT_EQ(step.text(0x0070030c), "RIGID");
        Eigen::Matrix4d matrix;
        for (int i = 0; i < 16; ++i) {
            matrix(i / 4, i % 4) = step.number(0x300600c6, static_cast<std::size_t>(i)).value_or(NAN);
        }
        return matrix;
    };
    EXPECT_LE((matrixOf(items[0]) - pose().matrix()).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_EQ(matrixOf(items[1]), Eigen::Matrix4d::Identity());
    const Eigen::Vector3d inPatient(10.0, -20.0, 30.0);
    const Eigen::Vector4d mapped = matrixOf(items[0]) * inPatient.homogeneous();
    EXPECT_LE((mapped.head<3>() - pose() * inPatient).norm(), 1e-9);
}

TEST_F(MadeObjects, RegistrationIsReadAsAPose)
{
    const auto read =
        io::readPose(written("registration", io::encodeSpatialRegistration(registration(), angiogram, origin)));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_LE((read.value().matrix() - pose().matrix()).cwiseAbs().maxCoeff(), 1e-9);
    const auto none = io::readPose(folder.file("run.dcm"));
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message.id(), "pose.no-registration");
}

TEST_F(MadeObjects, RegistrationsToOneImageShareItsCameraFrame)
{
    io::ObjectOrigin later = origin;
    later.seed = "another";
    EXPECT_EQ(io::cameraFrameOfReference(angiogram, origin), io::cameraFrameOfReference(angiogram, later));
}

TEST_F(MadeObjects, RefusesAPoseThatIsNotRigid)
{
    io::CArmRegistration broken = registration();
    broken.cameraFromPatient.rotation *= 1.1;
    EXPECT_FALSE(io::encodeSpatialRegistration(broken, angiogram, origin));
}

/// The voxels and their positions are read back by this program's segmentation reader.
TEST_F(MadeObjects, SegmentationLiesInTheScan)
{
    const std::string path = written("segmentation", io::encodeVesselSegmentation(vessels(), "drawn", scan, origin));
    const auto labels = io::readLabels(path);
    ASSERT_TRUE(labels) << labels.error().message;
    const core::VoxelMask mask = vessels();
    const auto volume = io::readVolume(folder.file("scan"));
    ASSERT_TRUE(volume) << volume.error().message;
    const core::VolumeGeometry& found = labels.value().geometry;
    const core::VolumeGeometry& wanted = volume.value().volume.geometry;
    EXPECT_EQ(found.size, wanted.size);
    EXPECT_LE((found.patientFromVoxel().matrix() - wanted.patientFromVoxel().matrix()).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LE((found.patientFromVoxel().matrix() - mask.geometry.patientFromVoxel().matrix()).cwiseAbs().maxCoeff(),
              1e-9);
    EXPECT_TRUE(std::ranges::equal(labels.value().voxels, mask.voxels));
}

TEST_F(MadeObjects, SegmentationRefersToTheSlicesItLiesOn)
{
    const auto object = io::encodeVesselSegmentation(vessels(), "drawn", scan, origin);
    ASSERT_TRUE(object);
    const io::DicomDataset data = parsedObject(object.value()).dataset;
    const std::vector<io::DicomDataset> frames = data.items(0x52009230);
    ASSERT_EQ(frames.size(), 5U);
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const io::DicomDataset derived = frames[k].items(0x00089124).front();
        EXPECT_EQ(derived.items(0x00082112).front().text(0x00081155), "1.2.3." + std::to_string(k + 1));
    }
    EXPECT_EQ(data.items(0x00081115).front().items(0x0008114a).size(), 5U);
    core::VoxelMask beside = vessels();
    beside.geometry.originInPatient.z() += 0.5;
    const auto shifted = io::encodeVesselSegmentation(beside, "drawn", scan, origin);
    ASSERT_TRUE(shifted);
    EXPECT_TRUE(parsedObject(shifted.value()).dataset.items(0x00081115).empty()) << "lies on no slice";
}

TEST_F(MadeObjects, EmptySegmentationIsRefused)
{
    EXPECT_FALSE(io::encodeVesselSegmentation(core::VoxelMask(vessels().geometry), "drawn", scan, origin));
}

TEST_F(MadeObjects, StateCountsPixelsFromTheCorner)
{
    const auto object = io::encodePresentationState(shownState(), angiogram, origin);
    ASSERT_TRUE(object) << object.error().message;
    const io::DicomDataset data = parsedObject(object.value()).dataset;
    const io::DicomDataset annotation = data.items(0x00700001).front();
    const io::DicomDataset line = annotation.items(0x00700009).front();
    const std::vector<double> expected{0.5, 0.5, 3.75, 8.0, 19.5, 15.5};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(line.number(0x00700022, i), expected[i]);
    }
    const io::DicomDataset image = annotation.items(0x00081140).front();
    EXPECT_EQ(image.text(0x00081155), angiogram.sopInstanceUid);
    EXPECT_EQ(image.integer(0x00081160), 2);
    // Black up to c - 0.5 - (w - 1) / 2 and white from c - 0.5 + (w - 1) / 2.
    const io::DicomDataset window = data.items(0x00283110).front();
    EXPECT_EQ(window.number(0x00281050), 600.5);
    EXPECT_EQ(window.number(0x00281051), 1001.0);
}

TEST_F(MadeObjects, StateOfAnInvertedImageStaysInverted)
{
    angiogram.isShownInverted = true;
    const auto object = io::encodePresentationState(shownState(), angiogram, origin);
    ASSERT_TRUE(object);
    EXPECT_EQ(parsedObject(object.value()).dataset.text(0x20500020), "INVERSE");
}

TEST_F(MadeObjects, StateCutsLinesThatAreTooLongForOneElement)
{
    io::PresentationContent shown = shownState();
    std::vector<Eigen::Vector2d> line;
    for (int i = 0; i < 20000; ++i) {
        line.emplace_back(i % 20, i % 16);
    }
    shown.layers[0].lines = {line};
    const auto object = io::encodePresentationState(shown, angiogram, origin);
    ASSERT_TRUE(object) << object.error().message;
    const io::DicomDataset annotation = parsedObject(object.value()).dataset.items(0x00700001).front();
    std::size_t segments = 0;
    for (const io::DicomDataset& part : annotation.items(0x00700009)) {
        segments += static_cast<std::size_t>(part.integer(0x00700021).value_or(0)) - 1;
    }
    EXPECT_EQ(segments, line.size() - 1);
}

TEST_F(MadeObjects, ReportWithoutMeasurementsIsRefused)
{
    EXPECT_FALSE(io::encodeMeasurementReport({}, angiogram, origin));
}

TEST(SourceImage, LeavesOutWhatNoReaderWouldTake)
{
    test::DicomBytes data;
    data.text(0x0008, 0x0020, "DA", "2024.02.29");
    data.text(0x0010, 0x0040, "CS", "FEMALE");
    data.text(0x0010, 0x1010, "AS", "74");
    data.text(0x0020, 0x000d, "UI", "hash-of-a-uid");
    data.text(0x0020, 0x000e, "UI", "1.2.3");
    const auto file = io::parseDicom(data.content(), "header");
    ASSERT_TRUE(file);
    const io::SourceImage source = io::sourceImageOf(file.value().dataset);
    EXPECT_EQ(source.patientText(0x00080020), "");
    EXPECT_EQ(source.patientText(0x00100040), "");
    EXPECT_EQ(source.patientText(0x00101010), "");
    EXPECT_EQ(source.studyUid, io::validUid("hash-of-a-uid"));
    EXPECT_FALSE(source.isReferenceable());
}

}   // namespace
