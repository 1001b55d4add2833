#include "tests/cli/run_program.h"
#include "tests/io/archive/archive_objects.h"
#include "tests/io/archive/orthanc.h"

#include <gtest/gtest.h>
#include <future>
#include <nlohmann/json.hpp>
#include <sstream>

namespace angiopose::test {
namespace {

/// Runs the command with its own list of archives.
ProgramOutcome runArchive(const TemporaryFolder& folder, std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "archive");
    arguments.insert(arguments.end(), {"--nodes", folder.file("archives.json")});
    return runCli(arguments);
}

std::vector<nlohmann::json> auditLines(const TemporaryFolder& folder)
{
    std::vector<nlohmann::json> lines;
    std::istringstream text(readText(folder.file("audit.jsonl")));
    for (std::string line; std::getline(text, line);) {
        lines.push_back(nlohmann::json::parse(line));
    }
    return lines;
}

TEST(ArchiveCommand, KeepsAListOfArchives)
{
    const TemporaryFolder folder;
    EXPECT_EQ(runArchive(folder, {"nodes", "add", "pacs", "--host", "10.0.0.7", "--title", "PACS"}).exitCode, 0);
    EXPECT_EQ(runArchive(folder, {"nodes", "add", "web", "--url", "https://web.example/dicom-web"}).exitCode, 0);
    const auto listed = nlohmann::json::parse(runArchive(folder, {"nodes", "list", "--json"}).output);
    ASSERT_EQ(listed["archives"].size(), 2u);
    EXPECT_EQ(listed["archives"][0]["address"], "10.0.0.7:104 PACS");
    EXPECT_EQ(runArchive(folder, {"nodes", "add", "bad", "--host", "a b"}).exitCode, 3);
    EXPECT_EQ(runArchive(folder, {"nodes", "remove", "web"}).exitCode, 0);
    const auto unknown = runArchive(folder, {"echo", "web"});
    EXPECT_EQ(unknown.exitCode, 3);
    EXPECT_NE(unknown.messages.find("available: pacs"), std::string::npos) << unknown.messages;
    EXPECT_EQ(runCli({"archive"}).exitCode, 2);
    EXPECT_EQ(runCli({"archive", "find"}).exitCode, 2);
}

TEST(ArchiveCommand, SaysWhichArchiveDoesNotAnswer)
{
    const TemporaryFolder folder;
    const std::string port = std::to_string(freePort());
    runArchive(folder, {"nodes", "add", "pacs", "--host", "127.0.0.1", "--port", port});
    const auto echoed = runArchive(folder, {"echo", "pacs", "--json"});
    EXPECT_EQ(echoed.exitCode, 3);
    EXPECT_EQ(nlohmann::json::parse(echoed.output)["error"]["id"], "archive.no-connection");
    EXPECT_NE(echoed.messages.find("pacs: 127.0.0.1:" + port), std::string::npos) << echoed.messages;
    EXPECT_EQ(runArchive(folder, {"find", "pacs", "--date", "soon"}).exitCode, 3);
}

TEST(ArchiveCommand, ReceivesWhatIsSent)
{
    const TemporaryFolder folder;
    const auto files = writeObjects(folder, "2.25.4711.51", 2);
    const std::string port = std::to_string(freePort());
    auto receiving = std::async(std::launch::async, [&] {
        return runCli({"--audit", folder.file("audit.jsonl"), "archive", "receive", "--port", port, "--into",
                       folder.file("in"), "--count", "2", "--json"});
    });
    runArchive(folder, {"nodes", "add", "here", "--host", "127.0.0.1", "--port", port, "--title", "ANGIOPOSE"});
    for (int i = 0; i < 50 && runArchive(folder, {"echo", "here"}).exitCode != 0; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    const auto sent = runArchive(folder, {"send", "here", folder.file("sent"), "--json"});
    EXPECT_EQ(sent.exitCode, 0) << sent.messages;
    EXPECT_EQ(nlohmann::json::parse(sent.output)["transferred"], 2);
    const auto received = receiving.get();
    EXPECT_EQ(received.exitCode, 0) << received.messages;
    EXPECT_EQ(nlohmann::json::parse(received.output)["transferred"], 2);
    EXPECT_TRUE(halfFiles(folder.file("in")).empty());
    std::size_t audited = 0;
    for (const nlohmann::json& line : auditLines(folder)) {
        EXPECT_EQ(line["event"], "received");
        audited += line["files"].size();
        EXPECT_EQ(line["files"][0]["sha256"].get<std::string>().size(), 64u);
    }
    EXPECT_EQ(audited, 2u);
}

TEST(ArchiveCommand, AuthoritiesWithoutACertificateAreNoTls)
{
    const TemporaryFolder folder;
    const auto outcome = runCli({"archive", "receive", "--port", std::to_string(freePort()), "--into",
                                 folder.file("in"), "--tls-ca", folder.file("ca.pem")});
    EXPECT_EQ(outcome.exitCode, 2) << "a port in the clear was not meant: " << outcome.messages;
}

TEST(ArchiveCommand, WhatIsRetrievedIsInTheAuditFile)
{
    const TemporaryFolder folder;
    const Orthanc orthanc;
    if (!orthanc.isRunning()) {
        GTEST_SKIP() << orthanc.whyNot();
    }
    writeObjects(folder, "2.25.4711.52", 3);
    runArchive(folder, {"nodes", "add", "pacs", "--host", "127.0.0.1", "--port", std::to_string(orthanc.dicomPort()),
                        "--title", Orthanc::title});
    ASSERT_EQ(runArchive(folder, {"send", "pacs", folder.file("sent")}).exitCode, 0);
    const std::vector<std::string> asked{"--audit",
                                         folder.file("audit.jsonl"),
                                         "archive",
                                         "retrieve",
                                         "pacs",
                                         "--study",
                                         studyUid,
                                         "--into",
                                         folder.file("in"),
                                         "--nodes",
                                         folder.file("archives.json")};
    const auto retrieved = runCli(asked);
    ASSERT_EQ(retrieved.exitCode, 0) << retrieved.messages;
    const auto lines = auditLines(folder);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0]["event"], "retrieved");
    EXPECT_EQ(lines[0]["archive"], "pacs");
    ASSERT_EQ(lines[0]["files"].size(), 3u);
    for (const nlohmann::json& file : lines[0]["files"]) {
        EXPECT_TRUE(file["path"].get<std::string>().starts_with(folder.file("in"))) << file;
        EXPECT_TRUE(file.contains("sha256")) << file;
    }
}

}   // namespace
}   // namespace angiopose::test
