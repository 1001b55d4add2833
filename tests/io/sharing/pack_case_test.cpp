#include "io/sharing/pack_case.h"

#include "tests/io/case/small_case.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <cstdlib>
#include <filesystem>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;

/// A case with a result and with texts that identify the patient.
class PackCase : public ::testing::Test {
protected:
    PackCase()
    {
        nlohmann::json json = small.json();
        json["title"] = "Jane Doe, 1950";
        json["somethingNew"] = "Jane Doe";
        json["pose"]["landmarks"] =
            nlohmann::json::array({{{"pointInPatientMm", {0, 0, 0}}, {"pixel", {3, 4}}, {"name", "LAD of Jane Doe"}}});
        small.folder().write("in/curves.csv", "x,y,operator\n3,4,Jane\n8,6,Doe\n");
        json["angiogram"]["centerline"]["path"] = "in/curves.csv";
        auto loaded = small.load(json);
        EXPECT_TRUE(loaded) << loaded.error().message.text();
        core::Case session = std::move(loaded).value();
        core::RegistrationResult result;
        result.method = "angiopose";
        result.cameraFromPatient = session.shown().cameraFromPatient;
        result.provenance.author = "Dr Doe";
        session.shown().result = result;
        session.shown().annotations.push_back({core::AnnotationKind::Text, {{2, 2}}, "Jane Doe"});
        EXPECT_TRUE(io::saveCase(session, casePath()));
    }

    std::string casePath() const { return small.path("JaneDoe.angiopose"); }

    /// The folder to which the packed case is extracted.
    std::string unpacked(const std::optional<io::DeidentificationOptions>& requested)
    {
        const std::string archive = small.path("pack.zip");
        const auto packed = io::packCaseFile(casePath(), archive, {requested, pseudonyms});
        EXPECT_TRUE(packed) << packed.error().message.text();
        const std::string folder = small.path("unpacked");
        fs::remove_all(folder);
        fs::create_directories(folder);
        EXPECT_EQ(std::system(("cd '" + folder + "' && cmake -E tar xf '" + archive + "'").c_str()), 0);
        return folder;
    }

    test::SmallCase small;
    io::Pseudonyms pseudonyms{"a key of more than sixteen bytes"};
};

TEST_F(PackCase, OpensElsewhereWithItsResult)
{
    const std::string folder = unpacked({});
    core::Messages warnings;
    const auto reopened = io::loadCase(folder + "/case.angiopose", warnings);
    ASSERT_TRUE(reopened) << reopened.error().message.text();
    EXPECT_TRUE(warnings.empty() || !test::anyContains(warnings, "changed"));
    EXPECT_EQ(reopened.value().title, "Jane Doe, 1950");
    EXPECT_TRUE(reopened.value().shown().result);
    EXPECT_EQ(reopened.value().shown().imageFile.path, fs::canonical(folder + "/view-1.png").string());
    for (const auto& entry : fs::directory_iterator(small.path(""))) {
        EXPECT_FALSE(entry.path().filename().string().starts_with(".angiopose-")) << "left behind: " << entry;
    }
}

TEST_F(PackCase, WithoutIdentityHoldsNoWordOfIt)
{
    const std::string folder = unpacked(io::DeidentificationOptions{});
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            const std::string content = test::readText(entry.path());
            for (const char* secret : {"Jane", "Doe", "1950", "somethingNew"}) {
                EXPECT_EQ(content.find(secret), std::string::npos) << entry.path() << ": " << secret;
            }
        }
    }
    core::Messages warnings;
    const auto reopened = io::loadCase(folder + "/case.angiopose", warnings);
    ASSERT_TRUE(reopened) << reopened.error().message.text();
    EXPECT_TRUE(reopened.value().shown().result);
    ASSERT_EQ(reopened.value().shown().landmarks.size(), 1U);
    EXPECT_EQ(reopened.value().shown().landmarks[0].name, "1");
    ASSERT_EQ(reopened.value().shown().annotations.size(), 1U);
    EXPECT_EQ(reopened.value().vessels.tree->branches.size(), 2U);
}

TEST_F(PackCase, SameCaseSameBytes)
{
    ASSERT_TRUE(io::packCaseFile(casePath(), small.path("a.zip"), {io::DeidentificationOptions{}, pseudonyms}));
    ASSERT_TRUE(io::packCaseFile(casePath(), small.path("b.zip"), {io::DeidentificationOptions{}, pseudonyms}));
    EXPECT_EQ(test::readText(small.path("a.zip")), test::readText(small.path("b.zip")));
}

TEST_F(PackCase, SaysWhyItCannot)
{
    const auto wrongEnding = io::packCaseFile(casePath(), small.path("pack.rar"), {{}, pseudonyms});
    ASSERT_FALSE(wrongEnding);
    EXPECT_EQ(wrongEnding.error().message.id(), "pack.format");
    fs::remove(small.path("in/image.png"));
    EXPECT_FALSE(io::packCaseFile(casePath(), small.path("pack.zip"), {{}, pseudonyms}));
    EXPECT_FALSE(fs::exists(small.path("pack.zip")));
}

TEST_F(PackCase, StopLeavesNothing)
{
    const auto stopped = io::packCaseFile(casePath(), small.path("pack.zip"), {{}, pseudonyms},
                                          [](double) { return core::ObserverDecision::Stop; });
    EXPECT_TRUE(stopped.isStopped());
    EXPECT_FALSE(fs::exists(small.path("pack.zip")));
}

TEST(PackPhantom, RealCaseGoesWithoutIdentity)
{
    const auto path = test::dataFile("coronary-phantom-xa/cases/IM1.angiopose");
    if (!fs::exists(path)) {
        GTEST_SKIP() << "no case at " << path;
    }
    const test::TemporaryFolder folder;
    const io::Pseudonyms pseudonyms("a key of more than sixteen bytes");
    const auto packed =
        io::packCaseFile(path.string(), folder.file("p.zip"), {io::DeidentificationOptions{}, pseudonyms});
    ASSERT_TRUE(packed) << packed.error().message.text();
    EXPECT_GT(fs::file_size(folder.file("p.zip")), 10'000U);
}

}   // namespace
