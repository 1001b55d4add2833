#include "core/geometry/c_arm.h"
#include "core/registration/registration.h"
#include "resources/translations/collect/scan_sentences.h"
#include "ui/words/core_texts.h"
#include "ui/words/language.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <string_view>

namespace angiopose::ui {
namespace {

using namespace std::string_view_literals;

/// Speaks a language for the length of a test.
class Speaking {
public:
    explicit Speaking(const char* code) { applyLanguage(QString::fromLatin1(code)); }
    ~Speaking() { applyLanguage(QStringLiteral("en")); }
    Speaking(const Speaking&) = delete;
    Speaking& operator=(const Speaking&) = delete;
};

TEST(ScanSentences, JoinsLiteralsAndNumbersWhatIsFilledIn)
{
    const auto found = core_texts::scanSentences(R"code(
        Error missing(int n) { return Error{"Only " + std::to_string(n) + " of " + names[0] + place + " is there."}; }
        const char* two = "A sentence in "
                          "two parts.";   // "A comment is none."
    )code");

    EXPECT_EQ(found, (std::set<std::string>{"Only %1 of %2 is there.", "A sentence in two parts."}));
}

TEST(ScanSentences, KnowBothBranchesOfAChoiceInASentence)
{
    const auto found = core_texts::scanSentences(
        R"code(warn("The image is " + std::string(dark ? "dark" : "bright") + " here.");)code");

    EXPECT_EQ(found, (std::set<std::string>{"The image is %1 here.", "dark", "bright"}));
}

TEST(ScanSentences, LeaveOutKeysUnitsAndCode)
{
    const auto found = core_texts::scanSentences(
        R"code(write("key"); write("mm"); write("NDims = 3"); write('"'); write("#Insight Transform File");)code");

    EXPECT_TRUE(found.empty());
}

TEST(CoreText, LeavesEnglishAsItIs)
{
    EXPECT_EQ(coreText("The vessels fit better 2.4 mm aside."sv),
              QStringLiteral("The vessels fit better 2.4 mm aside."));
}

TEST(CoreText, FindsTheTemplateASentenceWasMadeOf)
{
    const Speaking german("de");

    EXPECT_EQ(coreText("The vessels fit better 2.4 mm aside."sv),
              QStringLiteral("Die Gefäße passen 2,4 mm daneben besser."));
}

TEST(CoreText, TranslatesWhatIsFilledInBehindFileNamesAndBetweenDots)
{
    const Speaking german("de");

    EXPECT_EQ(
        coreText(core::cameraFromCArm({}, 512, 512).error().message),
        QStringLiteral("Der Abstand Fokus–Detektor (SID) fehlt oder ist nicht positiv. In der Geometrie des Falls "
                       "eintragen (der Bildheader nennt ihn nicht)."));
    EXPECT_EQ(coreText("a.nii: its voxels are cut short. Copy or export it again."sv),
              QStringLiteral("a.nii: die Voxel sind unvollständig. Neu kopieren oder exportieren."));
    EXPECT_EQ(coreText("SID 907 · SOD 720 mm (header)"sv), QStringLiteral("SID 907 · SOD 720 mm (Header)"));
    EXPECT_EQ(coreText("The vessel tree has no branch 3. The vessel tree has no branch 4."sv),
              QStringLiteral("Der Gefäßbaum hat keinen Ast 3. Der Gefäßbaum hat keinen Ast 4."));
}

TEST(CoreText, LeavesUnknownWordsAlone)
{
    const Speaking chinese("zh_CN");

    EXPECT_EQ(coreText("LAD proximal, 3 of 4"sv), QStringLiteral("LAD proximal, 3 of 4"));
}

TEST(CoreText, KnowsEveryOptionAndMethodInEveryLanguage)
{
    for (const char* code : {"de", "zh_CN"}) {
        const Speaking speaking(code);
        for (const core::OptionField& field : core::optionFields()) {
            EXPECT_NE(coreText(field.help), QString::fromUtf8(field.help)) << code << ": " << field.key;
        }
        for (const core::MethodInfo& info : core::methodInfos()) {
            EXPECT_NE(coreText(info.summary), QString::fromUtf8(info.summary)) << code << ": " << info.id;
        }
    }
}

}   // namespace
}   // namespace angiopose::ui