#pragma once

#include "io/angiogram_file.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>

#include <string>

namespace angiopose::test {

/// View 1, 2, … of the coronary phantom as stored in its file.
inline core::Angiogram phantomView(int view)
{
    auto read = io::readAngiogram(dataFile("coronary-phantom-xa/views-A/IM" + std::to_string(view) + ".dcm").string());
    EXPECT_TRUE(read) << read.error().message;
    return read ? std::move(read).value() : core::Angiogram{};
}

}   // namespace angiopose::test
