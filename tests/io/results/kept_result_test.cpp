#include "core/messages/messages.h"
#include "io/opening/open_result.h"
#include "io/results/result_file.h"
#include "io/results/result_schema.h"
#include "tests/io/case/small_case.h"

#include <gtest/gtest.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

using namespace angiopose;

namespace {

core::RigidTransform movedBy(double xMm)
{
    return core::expSe3((core::Vector6d() << 0.0, 0.0, 0.1, xMm, 0.0, 740.0).finished());
}

core::RegistrationResult resultOfRun(const std::string& time)
{
    core::RegistrationResult result;
    result.method = "dynaweight";
    result.cameraFromPatient = movedBy(3.0);
    result.provenance.start = movedBy(1.0);
    result.provenance.time = time;
    result.provenance.author = "Ada";
    result.provenance.frame = 0;
    result.provenance.options.method = "dynaweight";
    return result;
}

/// The stored result of a registration must contain its starting point, even long afterward.
class KeptResult : public testing::Test {
protected:
    void SetUp() override
    {
        auto loaded = small_.load(small_.json());
        ASSERT_TRUE(loaded) << loaded.error().message;
        session_ = std::move(loaded).value();
        session_.title = "Jane Doe's coronaries";
        keep(session_.shown(), "2026-11-26T10:00:00Z");
    }

    static void keep(core::View& view, const std::string& time)
    {
        view.result = resultOfRun(time);
        view.cameraFromPatient = view.result->cameraFromPatient;
    }

    io::ResultLocation write(io::ResultTexts names = io::ResultTexts::Kept)
    {
        return {small_.folder().write("results/result.json", io::storedResultJson(session_, names)),
                {small_.path("in")}};
    }

    test::SmallCase small_;
    core::Case session_;
    core::Messages warnings_;
};

TEST_F(KeptResult, TellsWhereItsRunBegan)
{
    session_.options.method = "rgbr";   // selected after the registration
    const auto place = write();
    const auto asked = io::openInputCase(place, warnings_);
    ASSERT_TRUE(asked) << asked.error().message;
    EXPECT_EQ(asked.value().shown().cameraFromPatient.matrix(), movedBy(1.0).matrix());
    EXPECT_EQ(asked.value().options.method, "dynaweight");
    EXPECT_FALSE(asked.value().shown().result);
    const auto found = io::openResultCase(place, warnings_);
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found.value().shown().cameraFromPatient.matrix(), movedBy(3.0).matrix());
}

TEST_F(KeptResult, StillKnowsItFromASavedCase)
{
    ASSERT_TRUE(io::saveCase(session_, small_.path("saved.angiopose")));
    const std::string before = io::storedResultJson(session_, io::ResultTexts::Kept);
    auto again = io::loadCase(small_.path("saved.angiopose"), warnings_);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(io::storedResultJson(again.value(), io::ResultTexts::Kept), before);
}

TEST_F(KeptResult, LeavesOutViewsOfOtherRuns)
{
    session_.views.insert(session_.views.begin(), 2, session_.views.front());
    keep(session_.views[0], "2026-11-26T09:00:00Z");   // registered alone, earlier
    session_.shownView = 2;
    const auto json = nlohmann::json::parse(io::storedResultJson(session_, io::ResultTexts::Kept));
    EXPECT_EQ(json["case"]["views"].size(), 1U);
    const auto found = io::openResultCase(write(), warnings_);
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found.value().views.size(), 2U);
}

TEST_F(KeptResult, TellsNoCaseWhereItsBeginningIsNotKnown)
{
    session_.shown().result->warnings = {core::messages::cameraEstimated(core::Quantity{98.0, 1, "%"}, 2, 3)};
    EXPECT_FALSE(nlohmann::json::parse(io::storedResultJson(session_, io::ResultTexts::Kept)).contains("case"));
    session_.shown().result->warnings.clear();
    session_.shown().result->provenance.start.reset();
    EXPECT_FALSE(nlohmann::json::parse(io::storedResultJson(session_, io::ResultTexts::Kept)).contains("case"));
    const auto asked = io::openInputCase(write(), warnings_);
    ASSERT_FALSE(asked);
    EXPECT_TRUE(test::contains(asked.error().message.text(), "does not record its inputs"));
}

TEST_F(KeptResult, WithoutNamesStillFindsItsInputs)
{
    const auto place = write(io::ResultTexts::LeftOut);
    const std::string text = test::readText(place.path);
    for (const char* name : {"Jane", "Ada", "tree.csv", "image.png", "2026-11-26"}) {
        EXPECT_EQ(text.find(name), std::string::npos) << name;
    }
    const auto asked = io::openInputCase(place, warnings_);
    ASSERT_TRUE(asked) << asked.error().message;
    EXPECT_EQ(asked.value().shown().cameraFromPatient.matrix(), movedBy(1.0).matrix());
}

TEST_F(KeptResult, KeepsToThePublishedSchema)
{
    std::ifstream file(std::string(RESOURCES_DIR) + "/angiopose-result.schema.json");
    ASSERT_TRUE(file);
    const auto schemaJson = nlohmann::json::parse(io::resultSchema());
    EXPECT_TRUE(nlohmann::json::parse(file) == schemaJson) << "angiopose-cli schema --result prints the new one";
    valijson::Schema schema;
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(schemaJson), schema);
    const auto keepsTo = [&schema](const nlohmann::json& json) {
        return valijson::Validator().validate(schema, valijson::adapters::NlohmannJsonAdapter(json), nullptr);
    };
    auto json = nlohmann::json::parse(io::storedResultJson(session_, io::ResultTexts::Kept));
    EXPECT_TRUE(keepsTo(json)) << json;
    json["pose"]["initial"] = 3;
    EXPECT_FALSE(keepsTo(json));
}

}   // namespace
