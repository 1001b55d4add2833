#include "tests/cli/run_program.h"
#include "tests/io/study/study_disc.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

TEST(Info, OfADicomdirListsItsStudies)
{
    const test::TemporaryFolder folder;
    test::writeDicomdir(folder.file(""), test::writeDisc(folder));
    const auto info = test::runCli({"info", folder.file("DICOMDIR")});
    EXPECT_EQ(info.exitCode, 0);
    EXPECT_NE(info.output.find("Phantom^CT"), std::string::npos) << info.output << info.messages;
    EXPECT_EQ(info.output, test::runCli({"studies", folder.file("DICOMDIR")}).output);
    const auto json = test::runCli({"info", folder.file("DICOMDIR"), "--json"});
    EXPECT_TRUE(json.output.starts_with("{")) << json.output;
}

}   // namespace
