#include "io/angiogram_file.h"
#include "io/image_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <zlib.h>
#include <cstring>

using namespace angiopose;

// Images that crashed decoders, and ordinary images that were rejected.

namespace {

/// Writes a PNG whose header chunk starts with these bytes and has a valid checksum.
std::string pngWithHeader(const test::TemporaryFolder& folder, const std::string& header)
{
    EXPECT_TRUE(io::writePng(core::Mask2d(40, 30), folder.file("sound.png")));
    std::string content = test::readText(folder.file("sound.png"));
    content.replace(16, header.size(), header);
    const uLong sum = crc32_z(0, reinterpret_cast<const Bytef*>(content.data() + 12), 17);
    for (std::size_t i = 0; i < 4; ++i) {
        content[29 + i] = static_cast<char>(sum >> (24 - 8 * i));
    }
    return folder.write("changed.png", content);
}

TEST(UnsafeImages, PngsWithAHeaderThatCannotBeAreRefused)
{
    const test::TemporaryFolder folder;
    EXPECT_TRUE(io::readAngiogram(pngWithHeader(folder, std::string("\0\0\0\x28", 4))));
    for (const std::string& header :
         {std::string("\0\0\0\0", 4), std::string("\xff\xff\xff\xff"), std::string("\x7f\xff\xff\xff"),
          std::string("\0\0\0\x28\0\0\0\x1e\x07", 9), std::string("\0\0\0\x28\0\0\0\x1e\x08\x03", 10)}) {
        const auto read = io::readAngiogram(pngWithHeader(folder, header));
        ASSERT_FALSE(read);
        EXPECT_NE(read.error().message.text().find("damaged"), std::string::npos) << read.error().message.text();
    }
}

TEST(UnsafeImages, PaddingBehindAJpegFrameIsNoDamage)
{
    ANGIOPOSE_NEEDS_DATA("exotic-dicom/pydicom/SC_rgb_jpeg_dcmtk.dcm");
    const std::string path = test::dataFile("exotic-dicom/pydicom/SC_rgb_jpeg_dcmtk.dcm").string();
    std::string content = test::readText(path);
    const std::size_t start = content.rfind("\xff\xd8\xff"), end = content.rfind("\xff\xd9");
    ASSERT_NE(start, std::string::npos);
    content.insert(end + 2, 18, '\0');
    std::uint32_t length = 0;
    std::memcpy(&length, content.data() + start - 4, sizeof length);
    length += 18;
    std::memcpy(content.data() + start - 4, &length, sizeof length);
    const test::TemporaryFolder folder;

    const auto padded = io::readAngiogram(folder.write("padded.dcm", content));

    ASSERT_TRUE(padded) << padded.error().message.text();
    const auto plain = io::readAngiogram(path);
    ASSERT_TRUE(plain) << plain.error().message.text();
    EXPECT_EQ(padded.value().frames.front().pixels, plain.value().frames.front().pixels);
}

}   // namespace
