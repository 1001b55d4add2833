#pragma once

#include <filesystem>
#include <string>

namespace angiopose::test {

/// Path of a real test file below ../shared/data.
inline std::filesystem::path dataFile(const std::string& relative)
{
    return std::filesystem::path(TEST_DATA_DIR) / relative;
}

}   // namespace angiopose::test
/// Skips the test, saying so, where the real data is not there.
#define ANGIOPOSE_NEEDS_DATA(relative)                                             \
    if (!std::filesystem::exists(test::dataFile(relative))) {                      \
        GTEST_SKIP() << "real data absent: " << test::dataFile(relative).string(); \
    }
