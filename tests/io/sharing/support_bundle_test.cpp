#include "io/sharing/support_bundle.h"

#include "io/sharing/case_summary.h"
#include "io/sharing/vocabulary.h"
#include "io/support/system/current_process.h"
#include "io/support/system/machine_info.h"
#include "tests/io/case/small_case.h"
#include "tests/io/deidentify/planted_run.h"
#include "tests/support/matchers.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <cstdlib>
#include <filesystem>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;

TEST(Redaction, TakesWhatIsKnownWhateverItsLetters)
{
    io::Redaction redaction;
    redaction.addName("MÜLLER^Jörg");
    redaction.addName("4711");
    const std::string clean = redaction.redact("müller, JÖRG (4711) has 47110 points of jörg_müller.");
    EXPECT_EQ(clean, "[name], [name] ([name]) has 47110 points of [name]_[name].");
}

TEST(Redaction, TakesPlacesUidsAndDates)
{
    const io::Redaction redaction;
    EXPECT_EQ(redaction.redact("/srv/pacs/x: it is damaged"), "[path]: it is damaged");
    EXPECT_EQ(redaction.redact("Written: Doe_1.png."), "Written: [file].png.");
    EXPECT_EQ(redaction.redact("of 1.2.840.10008.5.1 here"), "of [uid] here");
    EXPECT_EQ(redaction.redact("born 1962-03-14, 14.3.1962, 19620314 or 3/14/1962"),
              "born [date], [date], [date] or [date]");
    EXPECT_EQ(redaction.redact("ITK: 5.2.1, 2.5 px/mm, 0x19620314, 12:30:01"),
              "ITK: 5.2.1, 2.5 px/mm, 0x19620314, 12:30:01");
}

TEST(Redaction, LeavesWordsOfTheTradeAndEndings)
{
    io::Redaction redaction;
    redaction.addPath("/data/Doe/vessels/run.dcm");
    redaction.addText("Left and right of Doe");
    EXPECT_EQ(redaction.redact("vessels from .dcm and left of DOE"), "vessels from .dcm and left of [name]");
}

TEST(Redaction, TakesHomeAccountAndMachine)
{
    const io::Redaction redaction;
    const std::string account = io::accountName();
    const std::string host = io::hostName();
    const std::string clean =
        redaction.redact("user " + account + " on " + host + " in " + io::homeFolder() + "/images");
    EXPECT_FALSE(account.size() > 2 && test::contains(clean, account)) << clean;
    EXPECT_FALSE(host != "localhost" && test::contains(clean, host)) << clean;
    EXPECT_FALSE(io::homeFolder().size() > 1 && test::contains(clean, io::homeFolder())) << clean;
}

TEST(Vocabulary, LetOwnWordsThroughAlone)
{
    io::Vocabulary words;
    words.add("Written: %1");
    words.add("Geöffnet, 已打开");
    EXPECT_EQ(words.keepKnownWords("Written: Müller 2 of 123456"), "Written: […] 2 […] […]");
    EXPECT_EQ(words.keepKnownWords("Geöffnet 已打开王"), "Geöffnet 已打开[…]");
}

/// A case with planted identifiers in every text, path and header.
class SupportBundle : public ::testing::Test {
protected:
    SupportBundle()
    {
        const std::vector<std::int16_t> pixels(
            static_cast<std::size_t>(2 * test::PlantedRun::columns * test::PlantedRun::rows), 100);
        runPath = folder.file("PLANTED_Doe.dcm");
        test::writeText(runPath, run.content(pixels));
        nlohmann::json json = small.json();
        json["title"] = "PLANTED title";
        auto loaded = small.load(json);
        EXPECT_TRUE(loaded) << loaded.error().message.text();
        session = std::move(loaded).value();
        session.shown().imageFile.path = runPath;
        session.shown().name = "PLANTED view";
        session.shown().annotations.push_back({core::AnnotationKind::Text, {{2, 2}}, "PLANTED word"});
    }

    test::SmallCase small;
    test::TemporaryFolder folder;
    test::PlantedRun run;
    std::string runPath;
    core::Case session;
};

TEST_F(SupportBundle, HoldsNothingOfWhatWasPlanted)
{
    io::Redaction redaction;
    io::addIdentifiers(session, redaction);
    io::addIdentifiersOfFile(runPath, redaction);
    std::vector<io::SupportFile> texts = io::diagnosticFiles("OpenGL: 4.5 by PLANTED00\n");
    texts.push_back({"case.txt", io::caseSummary(session)});
    std::string log = "0:01 Opened " + runPath + "\n";
    for (int i = 0; i < run.count(); ++i) {
        std::array<char, 24> planted{};
        std::snprintf(planted.data(), planted.size(), "PLANTED%02d", i);
        log += std::string("0:02 of ") + planted.data() + " and 1.2.3.777.18, 20250314\n";
    }
    texts.push_back({"log.txt", log});
    const auto clean = io::redact(texts, redaction);
    const std::string all = io::joinTexts(clean);
    // Text that the headers do not store as text (curves, overlays, pixels) must not appear in any program message
    // either.
    io::Vocabulary own;
    own.add("Opened of and");
    const std::string logged = own.keepKnownWords(clean.back().text);
    for (const char* secret : {"PLANTED_Doe", "PLANTED title", "PLANTED view", "777.18", "20250314", "Doe"}) {
        EXPECT_FALSE(test::contains(all, secret)) << secret << " in " << all;
    }
    EXPECT_FALSE(test::contains(logged, "PLANTED")) << logged;
    EXPECT_TRUE(test::contains(all, "ITK: 5")) << all;
    EXPECT_TRUE(test::contains(all, "views: 1")) << all;
}

TEST_F(SupportBundle, IsAnArchiveOfTheseTexts)
{
    const std::string archive = folder.file("bundle.zip");
    ASSERT_TRUE(io::writeSupportBundle({{"program.txt", "one\n"}, {"log.txt", "two\n"}}, archive));
    const std::string to = folder.file("unpacked");
    fs::create_directories(to);
    ASSERT_EQ(std::system(("cd '" + to + "' && cmake -E tar xf '" + archive + "'").c_str()), 0);
    EXPECT_EQ(test::readText(to + "/program.txt"), "one\n");
    EXPECT_EQ(test::readText(to + "/log.txt"), "two\n");
}

}   // namespace
