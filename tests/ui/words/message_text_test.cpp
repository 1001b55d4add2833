#include "ui/words/message_text.h"

#include "core/geometry/c_arm.h"
#include "core/messages/messages.h"
#include "core/registration/registration.h"
#include "ui/words/language.h"
#include "ui/words/terms.h"

#include "core/registration/options/option_fields.h"

#include <gtest/gtest.h>

namespace angiopose::ui {
namespace {

namespace messages = core::messages;

class Speaking {
public:
    explicit Speaking(const char* code) { applyLanguage(QString::fromLatin1(code)); }
    ~Speaking() { applyLanguage(QStringLiteral("en")); }
    Speaking(const Speaking&) = delete;
    Speaking& operator=(const Speaking&) = delete;
};

TEST(MessageText, IsTheEnglishSentenceInEnglish)
{
    const core::Message message = messages::betterFitNearby(core::inMm(2.4, 1));

    EXPECT_EQ(messageText(message), QString::fromStdString(message.text()));
}

TEST(MessageText, WritesNumbersWithTheSignOfTheLanguage)
{
    const Speaking german("de");

    EXPECT_EQ(messageText(messages::betterFitNearby(core::inMm(2.4, 1))),
              QStringLiteral("Eine bessere Übereinstimmung liegt 2,4 mm entfernt."));
}

TEST(MessageText, TranslatesMessagesInsideAndBehindFileNames)
{
    const Speaking german("de");

    EXPECT_EQ(messageText(core::cameraFromCArm({}, 512, 512).error().message),
              QStringLiteral("Der Abstand Fokus–Detektor (SID) fehlt oder ist nicht positiv. Tragen Sie den Wert in "
                             "der C-Bogen-Geometrie ein (der Bildheader enthält ihn nicht)."));
    EXPECT_EQ(messageText(messages::noSuchBranch(3).about("a.vtp")),
              QStringLiteral("a.vtp: Der Gefäßbaum hat keinen Ast 3."));
    EXPECT_EQ(messagesText({messages::noSuchBranch(3), messages::noSuchBranch(4)}),
              QStringLiteral("Der Gefäßbaum hat keinen Ast 3. Der Gefäßbaum hat keinen Ast 4."));
}

TEST(MessageText, LeavesNamesAlone)
{
    const Speaking german("de");

    EXPECT_EQ(messageText(messages::noSuchMethod("1.5 %1", std::vector<std::string>{"2.5"})),
              QStringLiteral("Es gibt keine Methode „1.5 %1“. Wählen Sie eine von: 2.5."));
}

TEST(TermText, KnowsEveryOptionAndMethodInEveryLanguage)
{
    for (const char* code : {"de", "zh_CN"}) {
        const Speaking speaking(code);
        for (const core::OptionField& field : core::optionFields()) {
            EXPECT_NE(termText(field.help), QString::fromUtf8(field.help)) << code << ": " << field.key;
        }
        for (const core::MethodInfo& info : core::methodInfos()) {
            EXPECT_NE(termText(info.summary), QString::fromUtf8(info.summary)) << code << ": " << info.id;
        }
    }
}

TEST(TermText, LeavesUnknownWordsAlone)
{
    const Speaking chinese("zh_CN");

    EXPECT_EQ(termText(std::string_view("LAD proximal, 3 of 4")), QStringLiteral("LAD proximal, 3 of 4"));
}

}   // namespace
}   // namespace angiopose::ui
