#include "tests/io/volume/volume_bytes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

using namespace angiopose;

// Formats that store spacing and voxels but not the orientation of the axes in the patient.

namespace {

using test::TemporaryFolder;

void expectUnplaced(const core::Result<io::LoadedVolume>& loaded, const char* format)
{
    ASSERT_TRUE(loaded) << loaded.error().message.text();
    EXPECT_EQ(loaded.value().format, format);
    ASSERT_EQ(loaded.value().warnings.size(), 1U);
    EXPECT_NE(loaded.value().warnings.front().text().find("left and right"), std::string::npos);
    const core::Volume& volume = loaded.value().volume;
    EXPECT_EQ(volume.geometry.size, Eigen::Vector3i(2, 2, 2));
    EXPECT_LT((volume.geometry.spacingMm - Eigen::Vector3d(0.5, 2.0, 3.0)).norm(), 1e-6);
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        EXPECT_EQ(volume.value(i), 100.0 * static_cast<double>(i));
    }
}

/// Encodes numbers with the most significant byte first.
std::string bigEndianShorts(const std::vector<std::int16_t>& values)
{
    std::string bytes;
    for (const std::int16_t value : values) {
        bytes += static_cast<char>(value >> 8);
        bytes += static_cast<char>(value & 0xff);
    }
    return bytes;
}

const std::vector<std::int16_t> counted = {0, 100, 200, 300, 400, 500, 600, 700};

TEST(VtkImage, IsReadAsTextAndBinary)
{
    const TemporaryFolder folder;
    const auto header = [](const std::string& coding) {
        return "# vtk DataFile Version 3.0\nscan\n" + coding +
               "\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nSPACING 0.5 2 3\nORIGIN 0 0 0\nPOINT_DATA 8\n"
               "SCALARS scalars short 1\nLOOKUP_TABLE default\n";
    };
    expectUnplaced(io::readVolume(folder.write("text.vtk", header("ASCII") + "0 100 200 300 400 500 600 700\n")),
                   "VTK image");
    expectUnplaced(io::readVolume(folder.write("binary.vtk", header("BINARY") + bigEndianShorts(counted))),
                   "VTK image");
    test::expectRefused(folder.write("short.vtk", header("BINARY").replace(65, 16, "DIMENSIONS 9 9 9")), "truncated");
}

TEST(Gipl, IsReadWithItsSpacing)
{
    const TemporaryFolder folder;
    std::string header(256, '\0');
    header.replace(0, 10, bigEndianShorts({2, 2, 2, 1, 15}));   // sizes, 16-bit voxels
    header.replace(10, 12, std::string("\x3f\0\0\0\x40\0\0\0\x40\x40\0\0", 12));   // 0.5, 2, 3
    header.replace(252, 4, "\xef\xff\xe9\xb0");
    expectUnplaced(io::readVolume(folder.write("scan.gipl", header + bigEndianShorts(counted))), "GIPL");
    test::expectRefused(folder.write("short.gipl", header + "ab"), "truncated");
}

TEST(Analyze, IsReadAsAPair)
{
    const TemporaryFolder folder;
    std::string header(348, '\0');
    header.replace(0, 4, std::string("\x5c\x01\0\0", 4));
    header.replace(40, 16, test::bytesOf(std::vector<std::int16_t>{3, 2, 2, 2, 1, 1, 1, 1}));
    header.replace(70, 4, test::bytesOf(std::vector<std::int16_t>{4, 16}));
    header.replace(76, 16, test::bytesOf(std::vector<float>{0.0F, 0.5F, 2.0F, 3.0F}));
    folder.write("scan.img", test::bytesOf(counted));
    expectUnplaced(io::readVolume(folder.write("scan.hdr", header)), "Analyze");
    test::expectRefused(folder.write("alone.hdr", header), "alone.img is missing");
}

// Found by fuzzing: MetaIO, which used to read these headers, overran its buffer and crashed the program.
TEST(MetaImage, LinesOfAnyLengthAreRead)
{
    const test::TemporaryFolder folder;
    const std::string voxels(16, 'v');
    for (const std::string& line :
         {"Comment = " + std::string(3000, 'a'), std::string(255, 'k') + " = 1", "\r" + std::string(300, 'k'),
          std::string("Modality MR"), std::string("Modality = MR\r\nSeries"), std::string("  \r\n\t")}) {
        EXPECT_TRUE(io::readVolume(folder.write("a.mha", test::metaImage("MET_SHORT", voxels, line + "\n"))))
            << line.substr(0, 20);
    }
    test::expectRefused(folder.write("a.mha", test::metaImage("MET_SHORT", voxels, "Offset = 1,5 0 0\n")),
                        "header cannot be read");
}

}   // namespace
