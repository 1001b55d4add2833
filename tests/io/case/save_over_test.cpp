#include "io/case/overwrite_case.h"

#include "tests/io/case/small_case.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

core::Case renamed(core::Case session, const std::string& title)
{
    session.title = title;
    return session;
}

TEST(SaveCaseOver, KeepsWhatAnotherProgramHasSavedMeanwhile)
{
    test::SmallCase small;
    const auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded);
    const std::string path = small.path("case.angiopose");
    const std::string opened = io::caseFileHash(path);
    ASSERT_EQ(opened.size(), 64U);

    const auto first = io::overwriteCase(renamed(loaded.value(), "first window"), path, opened);
    ASSERT_TRUE(first);
    const auto second = io::overwriteCase(renamed(loaded.value(), "second window"), path, opened);

    ASSERT_FALSE(second);
    EXPECT_TRUE(io::isConcurrentChange(second.error())) << second.error().message;
    EXPECT_NE(test::readText(path).find("first window"), std::string::npos);
    EXPECT_TRUE(io::overwriteCase(renamed(loaded.value(), "once more"), path, first.value()));
    EXPECT_TRUE(io::overwriteCase(renamed(loaded.value(), "whatever is there"), path, {}));
    EXPECT_NE(test::readText(path).find("whatever is there"), std::string::npos);
}

TEST(SaveCaseOver, WritesACaseAgainThatWasRemoved)
{
    test::SmallCase small;
    const auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded);
    const std::string path = small.path("case.angiopose");
    const std::string opened = io::caseFileHash(path);
    std::filesystem::remove(path);
    EXPECT_EQ(io::caseFileHash(path), "");
    const auto saved = io::overwriteCase(loaded.value(), path, opened);
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved.value(), io::caseFileHash(path));
}

}   // namespace
