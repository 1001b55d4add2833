#include "io/support/system/child_process.h"
#include "io/support/system/current_process.h"
#include "io/support/system/files.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <chrono>
#include <string>

using namespace angiopose;

namespace {

using io::ChildProcess;
using io::FileKind;
using test::TemporaryFolder;
using test::writeText;

TEST(SystemFiles, AreToldApartWithoutOpeningThem)
{
    const TemporaryFolder folder;
    writeText(folder.file("five.txt"), "five5");
    ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
    EXPECT_EQ(io::fileStatus(folder.file("none")).kind, FileKind::Missing);
    EXPECT_EQ(io::fileStatus(folder.file("pipe")).kind, FileKind::Other);
    EXPECT_EQ(io::fileStatus(folder.file("five.txt/below")).kind, FileKind::Unreachable);
    EXPECT_FALSE(io::fileStatus(folder.file("five.txt/below")).problem.empty());
    EXPECT_EQ(io::fileStatus(folder.file("five.txt")).kind, FileKind::Regular);
    EXPECT_EQ(io::fileStatus(folder.file("five.txt")).size, 5U);
}

TEST(SystemFiles, AreReadAndMapped)
{
    const TemporaryFolder folder;
    writeText(folder.file("five.txt"), "five5");
    io::ReadHandle file(folder.file("five.txt"));
    ASSERT_TRUE(file.isOpen() && file.isRegular());
    const char* const mapping = file.map();
    ASSERT_NE(mapping, nullptr);
    EXPECT_EQ(std::string(mapping, file.size()), "five5");
    EXPECT_FALSE(io::findMappingFault(mapping, file.size()));
    io::unmap(mapping, file.size());
    std::array<char, 16> bytes{};
    EXPECT_EQ(file.read(bytes.data(), bytes.size()), 5U);
    EXPECT_EQ(file.read(bytes.data(), bytes.size()), 0U);
    EXPECT_FALSE(file.problem().empty());
    EXPECT_FALSE(io::ReadHandle(folder.file("none")).isOpen());
}

TEST(SystemFiles, APipeThatNobodyWritesToIsNotWaitedFor)
{
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
    const io::ReadHandle pipe(folder.file("pipe"));
    EXPECT_TRUE(pipe.isOpen());
    EXPECT_FALSE(pipe.isRegular());
}

std::string heardFrom(const ChildProcess& child)
{
    std::string all;
    std::array<char, 4> bytes{};
    while (true) {
        const ChildProcess::Output output = child.readOutput(bytes, -1);
        if (output.what == ChildProcess::ReadStatus::End) {
            return all;
        }
        all.append(bytes.data(), output.size);
    }
}

TEST(ChildProcesses, AreHeardToTheirEnd)
{
    ChildProcess child("/bin/sh", {"-c", "echo hello; echo lost >&2; cat; exit 3"});
    ASSERT_TRUE(child.isStarted());
    EXPECT_EQ(heardFrom(child), "hello\n");
    EXPECT_EQ(child.waitForExit(), ChildProcess::EndReason::Normal);
}

TEST(ChildProcesses, TellFaultsFromTimeThatRanOut)
{
    ChildProcess fault("/bin/sh", {"-c", "kill -SEGV $$"});
    EXPECT_EQ(fault.waitForExit(), ChildProcess::EndReason::Fault);
    ChildProcess late("/bin/sh", {"-c", "kill -XCPU $$"});
    EXPECT_EQ(late.waitForExit(), ChildProcess::EndReason::TimedOut);
    EXPECT_FALSE(ChildProcess("/nowhere/program", {}).isStarted());
}

TEST(ChildProcesses, EndWithWhoStartedThem)
{
    const auto start = std::chrono::steady_clock::now();
    {
        const ChildProcess silent("/bin/sleep", {"60"});
        std::array<char, 4> bytes{};
        EXPECT_EQ(silent.readOutput(bytes, 10).what, ChildProcess::ReadStatus::Nothing);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(OwnProcess, KnowsItsProgramAndItsMachine)
{
    EXPECT_TRUE(io::isExecutable(io::currentBinaryPath()));
    EXPECT_FALSE(io::isExecutable("/etc/passwd"));
    EXPECT_GT(io::physicalMemoryBytes(), 1e8);
}

TEST(OwnProcess, AProgramThatHasEndedIsNotAliveThoughNobodyAskedForIt)
{
    const pid_t child = ::fork();
    if (child == 0) {
        ::_exit(0);
    }
    siginfo_t ending{};
    ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(child), &ending, WEXITED | WNOWAIT), 0);   // it remains as a zombie
    EXPECT_FALSE(io::isProcessRunning(child));
    EXPECT_TRUE(io::isProcessRunning(::getpid()));
    ::waitpid(child, nullptr, 0);
    EXPECT_FALSE(io::isProcessRunning(child));
}

}   // namespace
