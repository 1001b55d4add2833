#include "io/support/atomic_file.h"

#include "io/support/file_limits.h"
#include "io/support/own_leftovers.h"
#include "tests/support/temporary_folder.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

std::size_t filesIn(const test::TemporaryFolder& folder)
{
    const auto place = std::filesystem::path(folder.file("x")).parent_path();
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(place), {}));
}

pid_t deadProcess()
{
    const pid_t child = ::fork();
    if (child == 0) {
        ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
    return child;
}

std::string temporaryOf(const std::string& target, pid_t maker)
{
    std::string name = io::temporaryPatternFor(target);
    const std::string own = "-" + std::to_string(::getpid()) + "-";
    name.replace(name.rfind(own), own.size(), "-" + std::to_string(maker) + "-");
    return name.replace(name.size() - 6, 6, "aB3dE6");
}

TEST(AtomicFile, RemovesWhatKilledProcessesLeft)
{
    const test::TemporaryFolder folder;
    const std::string target = folder.file("result.json");
    const std::string left = temporaryOf(target, deadProcess());
    const std::string living = temporaryOf(target, ::getppid());
    test::writeText(left, "half");
    test::writeText(living, "half");
    folder.write(".result.json.N32xHJ", "of somebody else");
    folder.write(".hidden", "of somebody else");
    ASSERT_TRUE(io::writeAtomically(target, "whole"));
    EXPECT_FALSE(std::filesystem::exists(left));
    EXPECT_TRUE(std::filesystem::exists(living));
    EXPECT_EQ(filesIn(folder), 4U);   // the target, the temporary file of the live process and the two unrelated files
    EXPECT_EQ(test::readText(target), "whole");
}

TEST(AtomicFile, LeavesTheTemporaryFileOfAKilledWriterToTheNext)
{
    const test::TemporaryFolder folder;
    const std::string target = folder.write("case.angiopose", "old");
    const pid_t child = ::fork();
    if (child == 0) {
        auto file = io::AtomicFile::create(target);
        auto writer = std::move(file).value();
        (void)writer.write("half");
        ::raise(SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
    EXPECT_EQ(filesIn(folder), 2U);
    EXPECT_EQ(test::readText(target), "old");
    EXPECT_EQ(io::removeLeftovers(std::filesystem::path(target).parent_path().string()), 1);
    EXPECT_EQ(filesIn(folder), 1U);
}

TEST(AtomicFile, TellsOfTheLimitForFilesInsteadOfDying)
{
    const test::TemporaryFolder folder;
    const std::string target = folder.write("volume.nii", "old");
    const pid_t child = ::fork();
    if (child == 0) {
        io::reportFileSizeLimit();
        const rlimit limit{4096, 4096};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        const auto written = io::writeAtomically(target, std::string(100'000, 'x'));
        ::_exit(!written && written.error().message.id() == "file.beyond-limit" ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 0);
    EXPECT_EQ(test::readText(target), "old");
    EXPECT_EQ(filesIn(folder), 1U);
}

TEST(AtomicFile, WritesNamesAsLongAsTheyMayBe)
{
    const test::TemporaryFolder folder;
    const std::string target = folder.file(std::string(250, 'n'));
    EXPECT_TRUE(io::writeAtomically(target, "whole"));
    EXPECT_EQ(test::readText(target), "whole");
}

}   // namespace
