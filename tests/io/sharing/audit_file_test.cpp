#include "io/sharing/audit_file.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;

TEST(AuditFile, SaysWhatWhenAndWithWhichContent)
{
    const test::TemporaryFolder folder;
    test::writeText(folder.file("case.angiopose"), "abc");
    const std::string audit = folder.file("audit.jsonl");
    ASSERT_TRUE(io::recordAudit(audit, {io::AuditEvent::Opened, "angiopose", {folder.file("case.angiopose")}}));
    ASSERT_TRUE(io::recordAudit(audit, {io::AuditEvent::Exported, "angiopose", {folder.file("gone.png")}}));
    std::istringstream lines(test::readText(audit));
    std::string line;
    std::getline(lines, line);
    const auto first = nlohmann::json::parse(line);
    EXPECT_EQ(first["event"], "opened");
    EXPECT_EQ(first["version"], ANGIOPOSE_VERSION);
    EXPECT_FALSE(first["user"].get<std::string>().empty());
    EXPECT_EQ(first["time"].get<std::string>().size(), 20U);
    EXPECT_EQ(first["files"][0]["path"], folder.file("case.angiopose"));
    EXPECT_EQ(first["files"][0]["sha256"], "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    std::getline(lines, line);
    EXPECT_EQ(nlohmann::json::parse(line)["files"][0]["unread"], true);
    EXPECT_EQ(fs::status(audit).permissions() & (fs::perms::group_all | fs::perms::others_all), fs::perms::none);
}

TEST(AuditFile, FilesThatComeOneByOneShareLines)
{
    const test::TemporaryFolder folder;
    test::writeText(folder.file("a.dcm"), "abc");
    const std::string audit = folder.file("audit.jsonl");
    io::AuditBatch batch(audit, {io::AuditEvent::Retrieved, "angiopose", {}, "pacs"});
    batch.flush();
    EXPECT_FALSE(fs::exists(audit)) << "nothing came";
    for (int i = 0; i < 199; ++i) {
        batch.add(folder.file("a.dcm"));
        batch.flushIfDue();
    }
    EXPECT_FALSE(fs::exists(audit)) << "not yet";
    batch.add(folder.file("a.dcm"));
    batch.flushIfDue();
    batch.add(folder.file("gone.dcm"));
    batch.flush();
    EXPECT_FALSE(batch.problem());
    std::istringstream lines(test::readText(audit));
    std::string first, second, none;
    std::getline(lines, first);
    std::getline(lines, second);
    EXPECT_FALSE(std::getline(lines, none));
    const auto parsed = nlohmann::json::parse(first);
    EXPECT_EQ(parsed["event"], "retrieved");
    EXPECT_EQ(parsed["archive"], "pacs");
    EXPECT_EQ(parsed["files"].size(), 200U);
    EXPECT_EQ(nlohmann::json::parse(second)["files"].size(), 1U);
    io::AuditBatch lost(folder.file("gone/audit.jsonl"), {io::AuditEvent::Received, "angiopose", {}});
    lost.add(folder.file("a.dcm"));
    lost.flush();
    EXPECT_TRUE(lost.problem());
}

TEST(AuditFile, ManyWritersLoseNoLine)
{
    const test::TemporaryFolder folder;
    const std::string audit = folder.file("audit.jsonl");
    std::vector<std::thread> writers;
    for (int w = 0; w < 4; ++w) {
        writers.emplace_back([&audit] {
            for (int i = 0; i < 25; ++i) {
                EXPECT_TRUE(io::recordAudit(audit, {io::AuditEvent::Saved, std::string(3000, 'x'), {}}));
            }
        });
    }
    for (std::thread& writer : writers) {
        writer.join();
    }
    std::istringstream lines(test::readText(audit));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        EXPECT_FALSE(nlohmann::json::parse(line, nullptr, false).is_discarded());
    }
    EXPECT_EQ(count, 100);
}

TEST(AuditFile, TellsThatItCannotBeWritten)
{
    const test::TemporaryFolder folder;
    const auto intoFolder = io::recordAudit(folder.file(""), {io::AuditEvent::Saved, "angiopose", {}});
    ASSERT_FALSE(intoFolder);
    EXPECT_EQ(intoFolder.error().message.id(), "audit.not-written");
    const auto full = io::recordAudit("/dev/full", {io::AuditEvent::Saved, "angiopose", {}});
    EXPECT_FALSE(full);
}

}   // namespace
