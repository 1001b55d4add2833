#include "app/preferences/apply_settings.h"
#include "app/preferences/settings.h"
#include "app/window_host.h"
#include "tests/app/open_window.h"
#include "tests/app/session/words_of_window.h"
#include "ui/controls/number_field.h"
#include "ui/panels/result_sentences.h"
#include "ui/words/language.h"
#include "ui/words/retranslation.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>

#include <tuple>

namespace angiopose::app {
namespace {

class WindowLanguage : public ::testing::Test {
protected:
    void SetUp() override
    {
        settings::language.write(QStringLiteral("en"));
        host = std::make_unique<WindowHost>();
        host->window().activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&host->window()));
        const auto sample = writeSampleCase();
        ASSERT_TRUE(sample);
        controller().open({sample.value()});
        waitForJudgement();
    }
    void TearDown() override
    {
        host.reset();
        settings::language.write(settings::language.fallback);
        ui::applyLanguage(QStringLiteral("en"));
    }

    CaseController& controller() { return host->controller(); }
    void waitForJudgement()
    {
        ASSERT_TRUE(test::waitFor([&] { return controller().evaluation() != nullptr; }));
    }
    void choose(ui::Command language)
    {
        host->window().actions()[language]->trigger();
        QTest::qWait(100);
    }
    QString firstMenu() { return host->window().header().menuBar()->actions().front()->text(); }

    std::unique_ptr<WindowHost> host;
};

TEST_F(WindowLanguage, ChangesAtOnceAndLosesNothing)
{
    CaseDocument& document = controller().document();
    const core::RigidTransform start = document.current().shown().cameraFromPatient;
    QTest::keyClick(&host->window().angiogramView(), Qt::Key_N);
    QTest::keyClick(&host->window().angiogramView(), Qt::Key_Left);
    const core::RigidTransform nudged = document.current().shown().cameraFromPatient;
    ASSERT_GT(test::distance(nudged, start), 0.5);
    controller().branches().select({1, 2});
    host->window().angiogramView().showPart({100.0, 300.0, 120.0, 260.0});
    host->window().angiogramView().setWindowLevel(77.0, 44.0);
    const double zoom = host->window().angiogramView().zoom();
    ASSERT_EQ(firstMenu(), QStringLiteral("&File"));

    choose(ui::Command::LanguageGerman);

    EXPECT_EQ(firstMenu(), QStringLiteral("&Datei"));
    ASSERT_EQ(&controller().document(), &document);
    EXPECT_EQ(test::distance(document.current().shown().cameraFromPatient, nudged), 0.0);
    EXPECT_TRUE(document.isModified());
    EXPECT_TRUE(host->window().windowTitle().contains(QLatin1Char('*')));
    EXPECT_EQ(controller().branches().marks().selected, (std::set<int>{1, 2}));
    // The same region is shown; longer German texts in the column may leave it a little less space.
    EXPECT_NEAR(host->window().angiogramView().zoom(), zoom, 0.1 * zoom);
    EXPECT_DOUBLE_EQ(host->window().angiogramView().shownRange().window(), 77.0);
    waitForJudgement();
    QTest::keyClick(&host->window().angiogramView(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(test::distance(document.current().shown().cameraFromPatient, start), 0.0);
}

TEST_F(WindowLanguage, ComesBack)
{
    choose(ui::Command::LanguageChinese);
    EXPECT_NE(firstMenu(), QStringLiteral("&File"));
    choose(ui::Command::LanguageEnglish);
    EXPECT_EQ(firstMenu(), QStringLiteral("&File"));
    EXPECT_TRUE(host->window().actions()[ui::Command::LanguageEnglish]->isChecked());
}

TEST_F(WindowLanguage, ChangesWhileARunGoesOn)
{
    controller().registration().start();
    ASSERT_TRUE(controller().registration().isRunning());
    choose(ui::Command::LanguageGerman);
    EXPECT_EQ(firstMenu(), QStringLiteral("&Datei"));
    ASSERT_TRUE(test::waitFor([&] { return !controller().registration().isRunning(); }));
    ASSERT_TRUE(controller().document().current().shown().result);
    EXPECT_FALSE(controller().document().current().shown().result->history.empty());
    EXPECT_EQ(host->window().registration().registerButton()->text(), QStringLiteral("Registrieren  R"));
    QTest::keyClick(&host->window().angiogramView(), Qt::Key_P);   // the run can still be replayed
    EXPECT_TRUE(host->window().actions()[ui::Command::Replay]->isChecked());
}

TEST_F(WindowLanguage, FollowingGoesOn)
{
    QTest::keyClick(&host->window().angiogramView(), Qt::Key_F, Qt::ShiftModifier);
    ASSERT_TRUE(controller().tracking().isRunning());
    choose(ui::Command::LanguageGerman);
    EXPECT_EQ(firstMenu(), QStringLiteral("&Datei"));
    EXPECT_TRUE(test::waitFor([&] { return !controller().tracking().isRunning(); }));
}

/// Words of one list that the other lacks.
std::string onlyIn(QStringList words, const QStringList& others)
{
    for (const QString& other : others) {
        words.removeOne(other);
    }
    return words.join(QStringLiteral(" | ")).toStdString();
}

/// What a window made in a language says, and what it says when it has learned the language later, is the same.
TEST_F(WindowLanguage, SaysEverythingInTheOtherWords)
{
    for (const auto& [command, code] :
         {std::pair{ui::Command::LanguageGerman, "de"}, std::pair{ui::Command::LanguageChinese, "zh_CN"},
          std::pair{ui::Command::LanguageEnglish, "en"}}) {
        choose(command);
        ASSERT_EQ(ui::currentLanguage(), QLatin1String(code));
        WindowHost fresh;
        fresh.controller().open({controller().document().path()});
        ASSERT_TRUE(test::waitFor([&] { return fresh.controller().evaluation() != nullptr; }));
        EXPECT_TRUE(
            QTest::qWaitFor([&] { return test::wordsOf(fresh.window()) == test::wordsOf(host->window()); }, 10000));
        const QStringList expected = test::wordsOf(fresh.window());
        const QStringList said = test::wordsOf(host->window());
        ASSERT_EQ(said.size(), expected.size())
            << code << ": said alone " << onlyIn(said, expected) << "; expected alone " << onlyIn(expected, said);
        ASSERT_GT(said.size(), 400);
        for (qsizetype i = 0; i < said.size(); ++i) {
            EXPECT_EQ(said[i].toStdString(), expected[i].toStdString()) << code;
        }
    }
}

/// In German no number has a point, wherever it stands; in English none has a comma.
TEST_F(WindowLanguage, WritesNumbersAsTheLanguageDoes)
{
    controller().registration().start();
    ASSERT_TRUE(test::waitFor([&] { return !controller().registration().isRunning(); }));
    QTest::keyClick(&host->window().angiogramView(), Qt::Key_K);
    waitForJudgement();
    const auto numbersLike = [this](const char* pattern) {
        // What stands in the header is shown as the file has it.
        static const QRegularExpression tag(QStringLiteral("[0-9A-F]{4},[0-9A-F]{4}[^\n|]*"));
        const QRegularExpression number{QString::fromLatin1(pattern)};
        QStringList found;
        for (QString words : test::wordsOf(host->window())) {
            words.remove(tag);
            if (words.contains(number)) {
                found << words;
            }
        }
        return found;
    };
    const auto* right = host->window().pose().findChildren<ui::NumberField*>().front();
    for (const auto& [command, own, foreign] :
         {std::tuple{ui::Command::LanguageGerman, "[0-9],[0-9]", "[0-9][.][0-9]"},
          std::tuple{ui::Command::LanguageChinese, "[0-9][.][0-9]", "[0-9],[0-9]"}}) {
        choose(command);
        waitForJudgement();
        QTest::qWait(200);
        EXPECT_GT(numbersLike(own).size(), 15);
        EXPECT_EQ(numbersLike(foreign).join(QLatin1Char('\n')).toStdString(), "");
        EXPECT_TRUE(right->text().contains(QRegularExpression(QString::fromLatin1(own))))
            << right->text().toStdString();
    }
}

/// Names of edits are translated again, with their arguments, on both sides of the history.
TEST_F(WindowLanguage, TranslatesWhatCanBeUndone)
{
    QAction* undo = host->window().actions()[ui::Command::Undo];
    QAction* redo = host->window().actions()[ui::Command::Redo];
    const auto only = [this] {
        return ui::displayName(controller().document().current().vessels.tree->branches.front());
    };
    controller().branches().toggleExcluded({controller().document().current().vessels.tree->branches.front().id});
    EXPECT_EQ(undo->text().toStdString(), QStringLiteral("Undo: Exclude %1").arg(only()).toStdString());
    core::RegistrationOptions options = controller().document().current().options;
    emit host->window().registration().optionsEdited(options, [] { return ui::RegistrationPanel::tr("method"); });
    undo->trigger();
    EXPECT_EQ(redo->text().toStdString(), "Redo: Change option “method”");

    choose(ui::Command::LanguageGerman);
    EXPECT_EQ(undo->text().toStdString(), QStringLiteral("Rückgängig: %1 ausschließen").arg(only()).toStdString());
    EXPECT_EQ(redo->text().toStdString(), "Wiederholen: Option „Methode“ ändern");
    choose(ui::Command::LanguageEnglish);
    EXPECT_EQ(undo->text().toStdString(), QStringLiteral("Undo: Exclude %1").arg(only()).toStdString());
}

/// A pose copied as text or written to a file is for programs, which know the point alone.
TEST_F(WindowLanguage, KeepsThePointInWhatProgramsRead)
{
    choose(ui::Command::LanguageGerman);
    host->window().actions()[ui::Command::CopyPose]->trigger();
    const QString matrix = QGuiApplication::clipboard()->text();
    EXPECT_TRUE(matrix.contains(QLatin1Char('.')));
    EXPECT_FALSE(matrix.contains(QLatin1Char(',')));
}

TEST_F(WindowLanguage, ButtonsNameTheKeyThatTheUserChose)
{
    const auto words = [this] { return host->window().registration().registerButton()->text(); };
    ASSERT_EQ(words(), QStringLiteral("Register  R"));
    QSettings().setValue(QStringLiteral("keys/register"), QStringLiteral("Ctrl+Alt+R"));
    applyShortcutSettings();
    ui::retranslate();
    EXPECT_TRUE(test::waitFor([&] { return words() == QStringLiteral("Register  Ctrl+Alt+R"); }));
    QSettings().remove(QStringLiteral("keys"));
    applyShortcutSettings();
}

}   // namespace
}   // namespace angiopose::app
