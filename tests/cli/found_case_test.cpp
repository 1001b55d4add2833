#include "tests/cli/simulated_case.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <filesystem>
#include <nlohmann/json.hpp>

using namespace angiopose;

namespace {

using test::runCli;

class CliFoundCase : public test::SimulatedCaseTest {};

TEST_F(CliFoundCase, WhatWasFoundIsSavedInTheCase)
{
    const std::string saved = folder_.file("found.angiopose");
    const auto found = runCli({"register", casePath_, "--output", folder_.file("result"), "--save", saved});
    ASSERT_EQ(found.exitCode, 0) << found.messages;
    const auto json = nlohmann::json::parse(runCli({"info", saved, "--json"}).output);
    EXPECT_EQ(json["pose"], "registered");
    EXPECT_EQ(json["result"]["trustworthy"], true);
    // The saved case is drawn as by register; for a case without a registration, the program reports that there is
    // none.
    const auto drawn = runCli({"project", saved, "--output", folder_.file("drawn.png")});
    ASSERT_EQ(drawn.exitCode, 0) << drawn.messages;
    EXPECT_EQ(drawn.messages.find("This case has not been registered"), std::string::npos) << drawn.messages;
    const auto start = runCli({"project", casePath_, "--output", folder_.file("start.png")});
    EXPECT_NE(start.messages.find("This case has not been registered"), std::string::npos) << start.messages;
    EXPECT_EQ(runCli({"project", casePath_, "--bare", "--output", folder_.file("bare.png")}).messages, "");
}

TEST_F(CliFoundCase, TwoFilesAreRegisteredAsTheirCaseIs)
{
    const std::string tree = folder_.file("demo/tree.vtp"), angiogram = folder_.file("demo/angiogram.dcm");
    const auto pair = runCli({"register", tree, angiogram, "--output", folder_.file("pair"), "--json"});
    ASSERT_EQ(pair.exitCode, 0) << pair.messages;
    const auto json = nlohmann::json::parse(pair.output);
    EXPECT_TRUE(json["trustworthy"].get<bool>());
    EXPECT_LT(json["metrics"]["medianProjectionDistancePx"].get<double>(), 1.0);
    EXPECT_EQ(runCli({"register", angiogram, tree, "--output", folder_.file("turned")}).exitCode, 0);
    EXPECT_EQ(runCli({"register", tree, "--output", folder_.file("alone")}).exitCode, 3);
    const auto gone = runCli({"register", tree, folder_.file("nowhere.dcm"), "--output", folder_.file("gone")});
    EXPECT_EQ(gone.exitCode, 3);
    EXPECT_NE(gone.messages.find("nowhere.dcm"), std::string::npos) << gone.messages;
}

TEST_F(CliFoundCase, DicomOfAStartPoseIsWrittenOnlyWhereItIsAskedFor)
{
    const std::string out = folder_.file("objects");
    const auto refused = runCli({"export-dicom", casePath_, "--output", out, "--objects", "reg"});
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_NE(refused.messages.find("--start-pose"), std::string::npos) << refused.messages;
    EXPECT_FALSE(std::filesystem::exists(out + "/registration.dcm"));
    EXPECT_EQ(runCli({"export-dicom", casePath_, "--output", out, "--objects", "reg", "--start-pose"}).exitCode, 0);

    ASSERT_EQ(runCli({"register", casePath_, "--output", folder_.file("result")}).exitCode, 0);
    const auto from = runCli({"export-dicom", "--from", folder_.file("result/result.json"), "--inputs",
                              folder_.file("demo"), "--output", folder_.file("again"), "--objects", "reg"});
    EXPECT_EQ(from.exitCode, 0) << from.messages;
    const auto camera = nlohmann::json::parse(test::readText(folder_.file("again/camera.json")));
    const auto result = nlohmann::json::parse(test::readText(folder_.file("result/result.json")));
    EXPECT_EQ(camera["cameraFromPatient"], result["pose"]["cameraFromPatient"]);
}

}   // namespace
