#include "io/series/dicom_segmentation.h"

#include "io/vessel_input_file.h"
#include "io/volume_file.h"
#include "tests/io/series/dicom_slices.h"
#include "tests/support/for_each.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

using namespace angiopose;

namespace {

using test::DicomBytes;
using test::TemporaryFolder;

constexpr int columns = 9;   // 9 × 7 pixels, so that frames do not end on whole bytes
constexpr int segmentRows = 7;
constexpr double layerMm = 1.25;

struct Frame {
    int segment = 1;
    int layer = 0;
};

struct Written {
    std::string type = "BINARY";
    int bitsAllocated = 1;
    std::vector<Frame> frames{{1, 4}, {1, 2}, {1, 3}, {2, 2}, {2, 4}};   // segment 2 leaves out its empty layer
    double firstX = -30.0;
    double shearMm = 0.0;   ///< sideways shift per layer
    std::string sopClass = "1.2.840.10008.5.1.4.1.1.66.4";
    std::string photometric = "MONOCHROME2";
};

/// Pixels of a segment in a layer: segment 1 is a vessel of four pixels, segment 2 overlaps it.
bool isIn(int segment, int layer, int x, int y)
{
    const int shift = segment == 2 ? 3 : 0;
    return x >= 2 + shift && x < 6 + shift && y >= 1 + layer % 2 && y < 5;
}

/// Position as from an oblique scanner: rows run along −y and columns along +z, so layers stack along −x.
std::string frameGroups(const Written& file, const Frame& frame)
{
    DicomBytes position;
    position.text(0x0020, 0x0032, "DS",
                  test::joined({file.firstX - layerMm * frame.layer, 12.0, 5.0 + file.shearMm * frame.layer}));
    DicomBytes segment;
    segment.number(0x0062, 0x000b, static_cast<std::uint16_t>(frame.segment));
    DicomBytes groups;
    groups.sequence(0x0020, 0x9113, {position.content()});
    groups.sequence(0x0062, 0x000a, {segment.content()});
    return groups.content();
}

std::string sharedGroups()
{
    DicomBytes orientation;
    orientation.text(0x0020, 0x0037, "DS", "0\\-1\\0\\0\\0\\1");
    DicomBytes measures;
    measures.text(0x0018, 0x0050, "DS", "2.5");   // the frame positions take precedence over this
    measures.text(0x0028, 0x0030, "DS", "0.8\\0.5");
    DicomBytes groups;
    groups.sequence(0x0020, 0x9116, {orientation.content()});
    groups.sequence(0x0028, 0x9110, {measures.content()});
    return groups.content();
}

std::string pixelsOf(const Written& file)
{
    std::string pixels;
    std::size_t bit = 0;
    for (const Frame& frame : file.frames) {
        for (int y = 0; y < segmentRows; ++y) {
            for (int x = 0; x < columns; ++x, ++bit) {
                const bool isSet = isIn(frame.segment, frame.layer, x, y);
                if (file.bitsAllocated == 8) {
                    pixels += static_cast<char>(isSet ? (file.type == "FRACTIONAL" ? 60 : frame.segment)
                                                      : 40 * (file.type == "FRACTIONAL"));
                    continue;
                }
                pixels.resize(bit / 8 + 1);
                pixels[bit / 8] = static_cast<char>(pixels[bit / 8] | (isSet ? 1 << bit % 8 : 0));
            }
        }
    }
    return pixels;
}

std::string segmentationBytes(const Written& file)
{
    std::vector<std::string> segments, perFrame;
    for (const int number : {1, 2}) {
        DicomBytes segment;
        segment.number(0x0062, 0x0004, static_cast<std::uint16_t>(number));
        segment.text(0x0062, 0x0005, "LO", number == 1 ? "Aorta" : "Iliac artery");
        segments.push_back(segment.content());
    }
    for (const Frame& frame : file.frames) {
        perFrame.push_back(frameGroups(file, frame));
    }
    DicomBytes data;
    data.text(0x0008, 0x0016, "UI", file.sopClass);
    data.text(0x0008, 0x0060, "CS", "SEG");
    data.number(0x0028, 0x0002, 1);
    data.text(0x0028, 0x0004, "CS", file.photometric);
    data.text(0x0028, 0x0008, "IS", std::to_string(file.frames.size()));
    data.number(0x0028, 0x0010, segmentRows);
    data.number(0x0028, 0x0011, columns);
    data.number(0x0028, 0x0100, static_cast<std::uint16_t>(file.bitsAllocated));
    data.number(0x0028, 0x0101, static_cast<std::uint16_t>(file.bitsAllocated));
    data.number(0x0028, 0x0102, static_cast<std::uint16_t>(file.bitsAllocated - 1));
    data.number(0x0028, 0x0103, 0);
    data.text(0x0062, 0x0001, "CS", file.type);
    data.sequence(0x0062, 0x0002, segments);
    data.number(0x0062, 0x000e, 100);
    data.sequence(0x5200, 0x9229, {sharedGroups()});
    data.sequence(0x5200, 0x9230, perFrame);
    data.bytes(0x7fe0, 0x0010, pixelsOf(file));
    return std::string(128, '\0') + "DICM" + data.content();
}

void expectPhantom(const core::LabelVolume& labels)
{
    ASSERT_EQ(labels.geometry.size, Eigen::Vector3i(columns, segmentRows, 3));   // layers 2 to 4
    EXPECT_TRUE(labels.geometry.spacingMm.isApprox(Eigen::Vector3d(0.5, 0.8, layerMm)));
    test::forEachVoxel({columns, segmentRows, 3}, [&](int x, int y, int k) {
        // The layers run along −x of the patient, as does the normal of the frames.
        const Eigen::Vector3d place = labels.geometry.patientFromVoxel() * Eigen::Vector3d(x, y, k);
        const int layer = static_cast<int>(std::lround((-30.0 - place.x()) / layerMm));
        const bool isSecond = layer != 3 && isIn(2, layer, x, y);
        EXPECT_EQ(labels.at(x, y, k), isIn(1, layer, x, y) ? 1 : isSecond ? 2 : 0) << x << " " << y << " " << k;
        EXPECT_NEAR(place.y(), 12.0 - 0.5 * x, 1e-9);
        EXPECT_NEAR(place.z(), 5.0 + 0.8 * y, 1e-9);
    });
}

core::LabelVolume readLabelsOrFail(const std::string& path)
{
    auto labels = io::readLabels(path);
    EXPECT_TRUE(labels) << labels.error().message;
    return labels ? std::move(labels).value() : core::LabelVolume{};
}

TEST(DicomSegmentation, ReadsBitsAcrossBytesOnTheGridOfAllSegments)
{
    const TemporaryFolder folder;
    expectPhantom(readLabelsOrFail(folder.write("seg.dcm", segmentationBytes({}))));
}

TEST(DicomSegmentation, ReadsFractionsFromHalfOn)
{
    const TemporaryFolder folder;
    expectPhantom(
        readLabelsOrFail(folder.write("seg.dcm", segmentationBytes({.type = "FRACTIONAL", .bitsAllocated = 8}))));
}

TEST(DicomSegmentation, ReadsLabelMapsInGrayAndInColor)
{
    const TemporaryFolder folder;
    for (const char* photometric : {"MONOCHROME2", "PALETTE COLOR"}) {
        const Written file{.type = "LABELMAP",
                           .bitsAllocated = 8,
                           .frames = {{2, 0}, {2, 1}},
                           .sopClass = "1.2.840.10008.5.1.4.1.1.66.7",
                           .photometric = photometric};
        const core::LabelVolume labels = readLabelsOrFail(folder.write("map.dcm", segmentationBytes(file)));
        EXPECT_EQ(labels.geometry.size, Eigen::Vector3i(columns, segmentRows, 2));
        EXPECT_EQ(std::count(labels.voxels.begin(), labels.voxels.end(), 2), 4 * (4 + 3)) << photometric;
    }
}

TEST(DicomSegmentation, ListsSegmentsByNumber)
{
    const TemporaryFolder folder;
    const auto segments = io::listSegments(folder.write("seg.dcm", segmentationBytes({})));
    ASSERT_TRUE(segments);
    ASSERT_EQ(segments.value().size(), 2u);
    EXPECT_EQ(segments.value()[1].number, 2);
    EXPECT_EQ(segments.value()[1].name, "Iliac artery");
}

TEST(DicomSegmentation, IsAVesselInput)
{
    const TemporaryFolder folder;
    const std::string path = folder.write("seg.dcm", segmentationBytes({}));
    const auto kind = io::vesselInputKindOf(path);
    ASSERT_TRUE(kind);
    EXPECT_EQ(kind.value(), core::VesselInputKind::Segmentation);
    const auto scan = io::readVolume(path);
    ASSERT_FALSE(scan);
    EXPECT_NE(scan.error().message.text().find("DICOM segmentation"), std::string::npos) << scan.error().message;
}

TEST(DicomSegmentation, RefusesWhatItCannotPlace)
{
    const TemporaryFolder folder;
    const auto messageOf = [&](const std::string& content) {
        const auto labels = io::readLabels(folder.write("bad.dcm", content));
        return labels ? std::string("no error") : labels.error().message.text();
    };
    EXPECT_NE(messageOf(segmentationBytes({.shearMm = 0.5})).find("DICOM segmentation"), std::string::npos);
    EXPECT_NE(messageOf(segmentationBytes({.frames = {{0, 1}}})).find("DICOM segmentation"), std::string::npos);
    EXPECT_NE(messageOf(segmentationBytes({.sopClass = "1.2.840.10008.5.1.4.1.1.2"})).find("not a segmentation"),
              std::string::npos);
    const std::string whole = segmentationBytes({});
    for (const std::size_t cut : {whole.size() - 1, whole.size() - 30, whole.size() / 2, std::size_t{200}}) {
        EXPECT_NE(messageOf(whole.substr(0, cut)), "no error") << cut;
    }
}

}   // namespace
