#include "io/support/crash_dumps.h"

#include "tests/support/matchers.h"
#include "tests/support/patience.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <csignal>
#include <cstdlib>
#include <fstream>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;

/// Crashes of a program linked with the handler, with its own state folder.
class CrashDumps : public ::testing::Test {
protected:
    CrashDumps() { ::setenv("XDG_STATE_HOME", folder_.file("state").c_str(), 1); }
    void SetUp() override
    {
        if (test::isSanitized) {
            GTEST_SKIP() << "the sanitizer takes the signals";
        }
    }
    ~CrashDumps() override { ::unsetenv("XDG_STATE_HOME"); }

    /// Crashes the program in the given way and returns the signal that ended it.
    static int crash(const std::string& way)
    {
        const int status = std::system((std::string("exec ") + CRASH_PROGRAM + " " + way + " 2>/dev/null").c_str());
        return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    }
    static std::string lastDump()
    {
        const auto dumps = io::crashDumps("angiopose-test");
        return dumps.empty() ? std::string() : io::demangleDump(dumps.front());
    }

    test::TemporaryFolder folder_;
};

TEST_F(CrashDumps, NameSignalAndFunctionAndEndByTheSameSignal)
{
    const std::vector<std::tuple<std::string, int, std::string>> ways{{"segv", SIGSEGV, "SIGSEGV"},
                                                                      {"fpe", SIGFPE, "SIGFPE"},
                                                                      {"ill", SIGILL, "SIGILL"},
                                                                      {"bus", SIGBUS, "SIGBUS"},
                                                                      {"abort", SIGABRT, "SIGABRT"}};
    for (const auto& [way, signal, name] : ways) {
        std::error_code ignored;
        fs::remove_all(folder_.file("state"), ignored);
        EXPECT_EQ(crash(way), signal) << way;
        const std::string dump = lastDump();
        EXPECT_TRUE(test::contains(dump, "signal: " + name)) << way << ": " << dump;
        EXPECT_TRUE(test::contains(dump, "crashOnPurpose(")) << way << ": " << dump;
        EXPECT_TRUE(test::contains(dump, "crash_on_purpose+0x")) << way << ": " << dump;
        EXPECT_TRUE(test::contains(dump, "program: angiopose-test " ANGIOPOSE_VERSION)) << dump;
        EXPECT_TRUE(test::contains(dump, "time: 20") && test::contains(dump, "thread: main")) << dump;
        EXPECT_TRUE(dump.ends_with("end\n")) << dump;
        EXPECT_FALSE(test::contains(dump, "/")) << "paths tell whose machine it is: " << dump;
    }
}

TEST_F(CrashDumps, AnExceptionNobodyCaughtIsNamedByItsTypeAlone)
{
    EXPECT_EQ(crash("terminate"), SIGABRT);
    EXPECT_TRUE(test::contains(lastDump(), "std::terminate: St13runtime_error")) << lastDump();
    EXPECT_FALSE(test::contains(lastDump(), "Jane"));
}

TEST_F(CrashDumps, AFullStackAndOtherThreadsLeaveOneToo)
{
    EXPECT_EQ(crash("stack"), SIGSEGV);
    EXPECT_TRUE(test::contains(lastDump(), "fillStack(")) << lastDump();
    EXPECT_EQ(crash("thread"), SIGSEGV);
    EXPECT_EQ(io::crashDumps("angiopose-test").size(), 2U);
}

TEST_F(CrashDumps, TheNewestTenAreKept)
{
    const fs::path folder = fs::path(folder_.file("state")) / "angiopose/crashes";
    fs::create_directories(folder);
    for (int i = 10; i < 30; ++i) {
        std::ofstream(folder / ("angiopose-20250101T0000" + std::to_string(i) + "Z-1.txt")) << "old";
    }
    std::ofstream(folder / "notes.txt") << "not ours";
    crash("segv");
    crash("segv");
    EXPECT_LE(io::crashDumps().size(), 11U);   // the last dump was written after counting
    EXPECT_EQ(io::crashDumps("angiopose-test").size(), 2U);
    EXPECT_TRUE(fs::exists(folder / "notes.txt"));
    EXPECT_EQ(fs::status(folder).permissions() & fs::perms::group_all, fs::perms::none);
}

}   // namespace
