#include "io/support/captured_stderr.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace angiopose;

namespace {

ino_t placeOfStderr()
{
    struct stat status {};
    fstat(STDERR_FILENO, &status);
    return status.st_ino;
}

TEST(CapturedStderr, KeepsWhatIsPrintedAndPutsStderrBack)
{
    const ino_t before = placeOfStderr();
    {
        io::CapturedStderr captured;
        std::fputs("Corrupt JPEG data\n", stderr);
        EXPECT_EQ(captured.text(), "Corrupt JPEG data\n");
        std::fputs("again\n", stderr);
        EXPECT_EQ(captured.text(), "Corrupt JPEG data\nagain\n");
        EXPECT_NE(placeOfStderr(), before);
    }
    EXPECT_EQ(placeOfStderr(), before);
    io::CapturedStderr empty;
    EXPECT_EQ(empty.text(), "");
}

}   // namespace
