#include "io/deidentify_files.h"

#include "tests/io/deidentify/planted_run.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <filesystem>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;

class DeidentifyFiles : public ::testing::Test {
protected:
    DeidentifyFiles()
    {
        const std::vector<std::int16_t> pixels(
            static_cast<std::size_t>(2 * test::PlantedRun::columns * test::PlantedRun::rows), 100);
        fs::create_directories(folder.file("in/below"));
        test::writeText(folder.file("in/Doe.dcm"), run.content(pixels));
        test::writeText(folder.file("in/below/Doe2.dcm"), test::PlantedRun().content(pixels));
        test::writeText(folder.file("in/letter.txt"), "Dear Jane Doe");
    }

    io::Pseudonyms pseudonyms{"a key of more than sixteen bytes"};
    test::TemporaryFolder folder;
    test::PlantedRun run;
};

TEST_F(DeidentifyFiles, WritesImagesAndNamesWhatItRefused)
{
    const std::string out = folder.file("out");
    const auto done = io::deidentifyFiles({folder.file("in"), folder.file("in/Doe.dcm")}, out, {}, pseudonyms);
    ASSERT_TRUE(done) << done.error().message.text();
    EXPECT_EQ(done.value().written, 2U);
    ASSERT_EQ(done.value().skipped.size(), 1U);
    EXPECT_NE(done.value().skipped.front().text().find("letter.txt"), std::string::npos);
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(out)) {
        EXPECT_EQ(entry.path().string().substr(out.size()).find("Doe"), std::string::npos) << entry;
        if (entry.is_regular_file()) {
            ++files;
            EXPECT_EQ(test::readText(entry.path()).find("PLANTED"), std::string::npos) << entry;
        }
    }
    EXPECT_EQ(files, 2);
}

TEST_F(DeidentifyFiles, LeavesNothingWhereStoppedOrNothingFits)
{
    const std::string out = folder.file("out");
    int asked = 0;
    const auto stopped = io::deidentifyFiles({folder.file("in")}, out, {}, pseudonyms, [&asked](double) {
        return ++asked > 1 ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    });
    ASSERT_FALSE(stopped);
    EXPECT_TRUE(stopped.isStopped());
    EXPECT_FALSE(fs::exists(out));
    EXPECT_FALSE(io::deidentifyFiles({folder.file("in/letter.txt")}, out, {}, pseudonyms));
    EXPECT_FALSE(fs::exists(out));
}

}   // namespace
