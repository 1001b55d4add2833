#include "io/case/save_over.h"

#include "io/messages/messages.h"
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
    const std::string opened = io::contentOfCaseFile(path);
    ASSERT_EQ(opened.size(), 64U);

    const auto first = io::saveCaseOver(renamed(loaded.value(), "first window"), path, opened);
    ASSERT_TRUE(first);
    const auto second = io::saveCaseOver(renamed(loaded.value(), "second window"), path, opened);

    ASSERT_FALSE(second);
    EXPECT_TRUE(io::isChangedElsewhere(second.error())) << second.error().message;
    EXPECT_NE(test::readText(path).find("first window"), std::string::npos);
    EXPECT_TRUE(io::saveCaseOver(renamed(loaded.value(), "once more"), path, first.value()));
    EXPECT_TRUE(io::saveCaseOver(renamed(loaded.value(), "whatever is there"), path, {}));
    EXPECT_NE(test::readText(path).find("whatever is there"), std::string::npos);
}

TEST(SaveCaseOver, WritesACaseAgainThatWasRemoved)
{
    test::SmallCase small;
    const auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded);
    const std::string path = small.path("case.angiopose");
    const std::string opened = io::contentOfCaseFile(path);
    std::filesystem::remove(path);
    EXPECT_EQ(io::contentOfCaseFile(path), "");
    const auto saved = io::saveCaseOver(loaded.value(), path, opened);
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved.value(), io::contentOfCaseFile(path));
}

}   // namespace
