#include "io/support/message_json.h"

#include "core/messages/messages.h"
#include "core/support/result.h"
#include "io/messages/messages.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

TEST(MessageJson, GivesIdSeverityTextAndArguments)
{
    const auto json = nlohmann::json::parse(messageJson(core::messages::poseUncertain(core::inMm(2.44, 1))));

    EXPECT_EQ(json["id"], "trust.pose-uncertain");
    EXPECT_EQ(json["severity"], "warning");
    EXPECT_EQ(json["text"], "The pose uncertainty is about 2.4 mm.");
    EXPECT_EQ(json["arguments"][0]["value"], 2.44);
    EXPECT_EQ(json["arguments"][0]["unit"], "mm");
    EXPECT_FALSE(json.contains("subject"));
}

TEST(MessageJson, GivesTheFileAndWhatIsInside)
{
    const core::Error error(core::messages::inView(2, messages::fileMissing().about("b.dcm")));
    const auto json = nlohmann::json::parse(messageJson(error.about("a.angiopose").message));

    EXPECT_EQ(json["severity"], "error");
    EXPECT_EQ(json["subject"], "a.angiopose");
    EXPECT_EQ(json["arguments"][1][0]["id"], "file.missing");
    EXPECT_EQ(json["arguments"][1][0]["subject"], "b.dcm");
}

TEST(MessageJson, ListsSeveral)
{
    const core::Messages warnings{core::messages::alternativePoseFits(), core::messages::registrationStopped()};
    const auto json = nlohmann::json::parse(messagesJson(warnings));

    ASSERT_EQ(json.size(), 2U);
    EXPECT_EQ(json[1]["id"], "trust.stopped");
    EXPECT_EQ(sentencesOf(warnings)[1], "The registration was stopped before it finished.");
}

}   // namespace
}   // namespace angiopose::io
