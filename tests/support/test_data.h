#pragma once

#include <filesystem>
#include <string>

namespace angiopose::test {

/// Path of a real test file in ../shared/data.
inline std::filesystem::path dataFile(const std::string& relative)
{
    return std::filesystem::path(TEST_DATA_DIR) / relative;
}

}   // namespace angiopose::test
/// Skips the test with a message if the real data is missing.
#define ANGIOPOSE_NEEDS_DATA(relative)                                             \
    if (!std::filesystem::exists(test::dataFile(relative))) {                      \
        GTEST_SKIP() << "real data absent: " << test::dataFile(relative).string(); \
    }
