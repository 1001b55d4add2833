#include "core/support/message.h"

#include "core/messages/messages.h"
#include "core/support/result.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

template <class Kind, class... Arguments>
concept TakesArguments = requires(const Kind& kind, const Arguments&... arguments)
{
    kind(arguments...);
};

// A wrong number of arguments must not compile.
static_assert(TakesArguments<decltype(messages::noSuchBranch), int>);
static_assert(!TakesArguments<decltype(messages::noSuchBranch)>);
static_assert(!TakesArguments<decltype(messages::noSuchBranch), int, int>);
static_assert(placeholderCount("%1 of %2 are within 5 %.") == 2);

TEST(Message, SaysItsArgumentsInEnglish)
{
    EXPECT_EQ(messages::noSuchBranch(7).text(), "The vessel tree has no branch 7.");
    EXPECT_EQ(messages::betterFitNearby(inMm(2.44, 1)).text(), "A better fit exists 2.4 mm away.");
    EXPECT_EQ(messages::treeOutsideImage(Quantity{31.2, 0, "%"}).text(),
              "Only 31 % of the vessel tree is inside the image.");
    EXPECT_EQ(messages::noSuchMethod("guess", std::vector<std::string>{"angiopose", "dt-icp"}).text(),
              "There is no method 'guess'. Choose one of: angiopose, dt-icp.");
}

TEST(Message, HoldsOtherMessages)
{
    const Message inner = messages::noSuchBranch(7);
    const Message outer = messages::inView(2, inner);

    EXPECT_EQ(outer.text(), "View 2: The vessel tree has no branch 7.");
    EXPECT_EQ(std::get<Messages>(outer.arguments()[1]).front(), inner);
}

TEST(Message, IsToldByItsIdWhateverItSays)
{
    EXPECT_TRUE(messages::noSuchBranch(7).is(messages::noSuchBranch));
    EXPECT_FALSE(messages::noSuchBranch(7).is(messages::duplicateBranchId));
    EXPECT_EQ(messages::noSuchBranch(7).id(), "tree.no-such-branch");
    EXPECT_NE(messages::noSuchBranch(7), messages::noSuchBranch(8));
}

TEST(Message, NamesWhatItIsAboutOuterFirst)
{
    EXPECT_EQ(messages::volumeEmpty().about("vessel").about("a.angiopose").text(),
              "a.angiopose: vessel: The volume is empty. Choose another series or file.");
}

TEST(Message, KeepsPercentSignsThatAreNoPlaces)
{
    static constexpr MessageKind<1> kind{{"test.percent", "100 % of %1"}};

    EXPECT_EQ(kind("50 %1").text(), "100 % of 50 %1");
}

TEST(Result, TellsStopFromErrors)
{
    const Result<int> stopped = Cancellation{messages::tracingStopped()};
    const Result<int> failed = Error(messages::volumeEmpty());

    EXPECT_TRUE(stopped.isStopped());
    EXPECT_EQ(stopped.error().message.severity(), Severity::Note);
    EXPECT_FALSE(failed.isStopped());
    EXPECT_EQ(failed.error().message.severity(), Severity::Error);
    EXPECT_FALSE(Result<int>(3).isStopped());
    EXPECT_TRUE(stopped.error().about("a.nii").isCancellation());
}

}   // namespace
}   // namespace angiopose::core
