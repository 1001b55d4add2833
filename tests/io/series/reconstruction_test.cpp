#include "io/angiogram_file.h"
#include "io/opening/input_kind.h"
#include "tests/io/series/ct_phantom.h"

#include <gtest/gtest.h>

using namespace angiopose;

// Reconstructed rotational angiograms are in patient coordinates, although they come from a C-arm and are labeled as
// such.

namespace {

using test::DicomBytes;
using test::TemporaryFolder;

constexpr int columnCount = 12, rowCount = 10, layers = 6;

std::int16_t valueAt(int i, int j, int k)
{
    return static_cast<std::int16_t>(1000 + i + 20 * j + 300 * k);
}

std::string item(std::uint16_t group, std::uint16_t element, const char* vr, const std::string& value)
{
    DicomBytes data;
    data.text(group, element, vr, value);
    return data.content();
}

/// Frames with their own plane positions: 1 x 1 x 2 mm from (-50, -60, 10).
std::string multiFrame(const std::string& sopClass)
{
    std::vector<std::int16_t> pixels;
    std::vector<std::string> frames;
    for (int k = 0; k < layers; ++k) {
        DicomBytes frame;
        frame.sequence(0x0020, 0x9113, {item(0x0020, 0x0032, "DS", "-50\\-60\\" + std::to_string(10 + 2 * k))});
        frames.push_back(frame.content());
        for (int at = 0; at < columnCount * rowCount; ++at) {
            pixels.push_back(valueAt(at % columnCount, at / columnCount, k));
        }
    }
    DicomBytes shared;
    shared.sequence(0x0020, 0x9116, {item(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0")});
    shared.sequence(0x0028, 0x9110, {item(0x0028, 0x0030, "DS", "1\\1")});
    shared.sequence(0x0028, 0x9145, {item(0x0028, 0x1052, "DS", "-1024") + item(0x0028, 0x1053, "DS", "1")});
    DicomBytes data;
    data.text(0x0008, 0x0016, "UI", sopClass);
    data.text(0x0008, 0x0018, "UI", "1.2.3.1");
    data.text(0x0008, 0x0060, "CS", "XA");
    data.text(0x0020, 0x000d, "UI", "1.2");
    data.text(0x0020, 0x000e, "UI", "1.2.3");
    data.number(0x0028, 0x0002, 1);
    data.text(0x0028, 0x0004, "CS", "MONOCHROME2");
    data.text(0x0028, 0x0008, "IS", std::to_string(layers));
    data.number(0x0028, 0x0010, rowCount);
    data.number(0x0028, 0x0011, columnCount);
    data.number(0x0028, 0x0100, 16);
    data.number(0x0028, 0x0101, 16);
    data.number(0x0028, 0x0102, 15);
    data.number(0x0028, 0x0103, 0);
    data.sequence(0x5200, 0x9229, {shared.content()});
    data.sequence(0x5200, 0x9230, frames);
    data.words(0x7fe0, 0x0010, pixels);
    return std::string(128, '\0') + "DICM" + data.content();
}

}   // namespace

TEST(Reconstruction, OfOneFileIsAVolume)
{
    const TemporaryFolder folder;
    for (const char* sopClass : {"1.2.840.10008.5.1.4.1.1.13.1.1", "1.2.840.10008.5.1.4.1.1.13.1.2",
                                 "1.2.840.10008.5.1.4.1.1.12.1.1", "1.2.840.10008.5.1.4.1.1.7.3"}) {
        SCOPED_TRACE(sopClass);
        const std::string path = folder.write("3dra.dcm", multiFrame(sopClass));
        const auto loaded = io::readVolume(path);
        ASSERT_TRUE(loaded) << loaded.error().message;
        const core::Volume& volume = loaded.value().volume;
        EXPECT_EQ(volume.geometry.size, Eigen::Vector3i(columnCount, rowCount, layers));
        EXPECT_LT((volume.geometry.spacingMm - Eigen::Vector3d(1, 1, 2)).norm(), 1e-9);
        EXPECT_LT((volume.geometry.originInPatient - Eigen::Vector3d(-50, -60, 10)).norm(), 1e-9);
        EXPECT_EQ(volume.value(volume.geometry.index(3, 5, 2)), valueAt(3, 5, 2) - 1024);
        EXPECT_EQ(io::inputKindOf(path).value(), io::InputKind::Vessels);
        const auto image = io::readAngiogram(path);
        EXPECT_TRUE(!image || test::mentions(image.value().warnings, "a volume reconstructed from projections"));
    }
}

TEST(Reconstruction, OfSlicesOfAnotherClassIsAVolume)
{
    const TemporaryFolder folder;
    const core::Volume phantom = test::ctPhantom();
    for (const char* sopClass : {"1.2.840.10008.5.1.4.1.1.2", "1.2.840.10008.5.1.4.1.1.7"}) {
        std::string path;
        for (test::CtSlice slice : test::allSlices(phantom)) {
            slice.modality = "XA";
            DicomBytes head;
            head.text(0x0008, 0x0016, "UI", sopClass);
            const std::string plain = test::ctSlice(slice);
            path = folder.write(std::string(sopClass) + "/" + slice.sopInstanceUid,
                                plain.substr(0, 132) + head.content() + plain.substr(132));
        }
        const auto loaded = io::readVolume(folder.file(sopClass));
        ASSERT_TRUE(loaded) << loaded.error().message;
        EXPECT_LT(test::largestDisplacement(phantom, loaded.value().volume), 1e-6) << sopClass;
        EXPECT_EQ(io::inputKindOf(path).value(), io::InputKind::Vessels);
    }
}
