#include "io/support/base64.h"

#include <gtest/gtest.h>

using namespace angiopose;

TEST(Base64, FillsTheLastGroup)
{
    EXPECT_EQ(io::base64(""), "");
    EXPECT_EQ(io::base64("f"), "Zg==");
    EXPECT_EQ(io::base64("fo"), "Zm8=");
    EXPECT_EQ(io::base64("foo"), "Zm9v");
    EXPECT_EQ(io::base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, LongBytesHaveNoSeam)
{
    const std::string bytes(3 * 65536 + 3, 'x');
    const std::string letters = io::base64(bytes);
    ASSERT_EQ(letters.size(), bytes.size() / 3 * 4);
    for (std::size_t at = 0; at < letters.size(); at += 4) {
        ASSERT_EQ(letters.substr(at, 4), "eHh4") << at;
    }
}
