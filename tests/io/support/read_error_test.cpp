
#include "io/support/input_bytes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <filesystem>

namespace angiopose::io {
namespace {

constexpr std::size_t pageBytes = 4096;

}   // namespace

/// Raises the same signal as a scratched disc, without needing one.
TEST(ReadError, IsToldOfBytesThatAreGone)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.write("scan.raw", std::string(8 * pageBytes, 'x'));
    const auto input = openInput(path);
    ASSERT_TRUE(input);
    const std::string_view content = input.value().view();
    EXPECT_FALSE(findReadError(content.data(), content.size()));
    std::filesystem::resize_file(path, 2 * pageBytes);
    EXPECT_FALSE(findReadError(content.data(), 2 * pageBytes));
    const auto problem = findReadError(content.data(), content.size());
    ASSERT_TRUE(problem);
    EXPECT_NE(problem->text().find("Input/output error"), std::string::npos) << problem->text();
}

TEST(ReadError, LeavesSmallAndLargeFilesReadable)
{
    const test::TemporaryFolder folder;
    for (const std::size_t size : {std::size_t{1}, pageBytes + 1, startBytes + 1}) {
        const std::string path = folder.write("scan.raw", std::string(size, 'x'));
        for (const auto& input : {openInput(path), openInputStart(path)}) {
            ASSERT_TRUE(input);
            EXPECT_EQ(input.value().view(), std::string(size, 'x'));
        }
    }
}

}   // namespace angiopose::io
