#include "core/registration/judging/unopacified_branches.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

TEST(UnfilledBranches, AreNamedWhileOthersCarryThePose)
{
    const Messages reported = unopacifiedMessages({{7, 0.9}}, 0.6, 3);
    ASSERT_EQ(reported.size(), 1U);
    EXPECT_EQ(reported.front().id(), "trust.part-filled");
    EXPECT_NE(reported.front().text().find("7"), std::string::npos);
}

/// Regression test for the text "24 of 24 branches … The pose rests on the others."
TEST(UnfilledBranches, AreNoOthersWhereAllAre)
{
    const Messages reported = unopacifiedMessages({{1, 0.9}, {2, 0.8}, {3, 0.95}}, 0.08, 3);
    ASSERT_EQ(reported.size(), 1U);
    EXPECT_EQ(reported.front().id(), "trust.pieces-filled");
    EXPECT_EQ(reported.front().text().find("others"), std::string::npos);
}

}   // namespace
}   // namespace angiopose::core
