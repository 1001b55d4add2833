#include "io/support/case_lock.h"

#include "io/support/system/current_process.h"

#include "io/support/own_leftovers.h"
#include "tests/support/temporary_folder.h"

#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

TEST(CaseLock, TellsOthersWhoHasTheCaseOpen)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.write("a.angiopose", "{}");
    EXPECT_FALSE(io::lockHolderOf(path));
    {
        const io::CaseLock lock(path);
        EXPECT_TRUE(lock.isHeld());
        const auto holder = io::lockHolderOf(path);
        ASSERT_TRUE(holder);
        EXPECT_EQ(holder->process, ::getpid());
        EXPECT_EQ(holder->machine, io::hostName());
        EXPECT_FALSE(io::CaseLock(path).isHeld());
        std::filesystem::create_symlink(path, folder.file("link.angiopose"));
        EXPECT_TRUE(io::lockHolderOf(folder.file("link.angiopose")));   // a link to the same case
    }
    EXPECT_FALSE(io::lockHolderOf(path));
    EXPECT_FALSE(std::filesystem::exists(io::lockPathOf(path)));
}

TEST(CaseLock, IsFreeAgainWhenItsProgramWasKilled)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.write("a.angiopose", "{}");
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const io::CaseLock lock(path);
        (void)!::write(ready[1], lock.isHeld() ? "y" : "n", 1);
        ::pause();
    }
    char answer = ' ';
    ASSERT_EQ(::read(ready[0], &answer, 1), 1);
    EXPECT_EQ(answer, 'y');
    const auto holder = io::lockHolderOf(path);
    ASSERT_TRUE(holder);
    EXPECT_EQ(holder->process, child);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_TRUE(std::filesystem::exists(io::lockPathOf(path)));   // a stale lock file
    EXPECT_FALSE(io::lockHolderOf(path));
    EXPECT_EQ(io::removeLeftovers(std::filesystem::path(path).parent_path().string()), 1);
    EXPECT_FALSE(std::filesystem::exists(io::lockPathOf(path)));
    EXPECT_TRUE(io::CaseLock(path).isHeld());
    ::close(ready[0]);
    ::close(ready[1]);
}

TEST(CaseLock, WantsNothingOfFoldersThatAreNotThere)
{
    EXPECT_FALSE(io::CaseLock("/nowhere/at/all.angiopose").isHeld());
    EXPECT_FALSE(io::lockHolderOf("/nowhere/at/all.angiopose"));
}

}   // namespace
