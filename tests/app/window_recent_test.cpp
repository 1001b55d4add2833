#include "app/files/recent_cases.h"
#include "app/files/recent_controller.h"
#include "tests/app/open_window.h"
#include "tests/support/for_each.h"

#include <QCheckBox>
#include <QDir>
#include <QMenu>
#include <QPainter>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <future>

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;

qsizetype picturesStored()
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/cases"));
    return folder.entryList({QStringLiteral("*.png")}, QDir::Files).size();
}

QList<QPushButton*> recentButtons(const OpenWindow& w)
{
    QList<QPushButton*> buttons;
    for (QPushButton* button : w.window.findChildren<QPushButton*>()) {
        if (button->property("role") == QStringLiteral("recent")) {
            buttons << button;
        }
    }
    return buttons;
}

void save(OpenWindow& w, const QString& path)
{
    w.controller.saveController().saveTo(path);
    ASSERT_TRUE(test::waitFor([&w] { return !w.controller.saveController().isSaving(); }));
}

TEST(WindowRecent, ASavedCaseShowsItsPictureOnTheFirstPage)
{
    forgetRecentCases();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("seen.angiopose"));
    {
        SampleWindow w;
        save(w, path);
    }
    const QImage picture = caseThumbnail(path);
    ASSERT_FALSE(picture.isNull());
    EXPECT_EQ(picture.width(), caseThumbnailWidthPx);

    OpenWindow w;
    const auto colorsOfTile = [&w] {
        const QList<QPushButton*> buttons = recentButtons(w);
        const QImage tile = buttons.isEmpty() ? QImage() : buttons.front()->icon().pixmap(44, 44).toImage();
        QSet<QRgb> colors;
        test::forEachPixel(tile.width(), tile.height(), [&](int x, int y) { colors.insert(tile.pixel(x, y)); });
        return colors.size();
    };
    EXPECT_TRUE(test::waitFor([&] { return colorsOfTile() > 100; })) << "a picture, not a tile";
    ASSERT_FALSE(recentButtons(w).isEmpty());
    EXPECT_EQ(recentButtons(w).front()->text(), QStringLiteral("seen.angiopose"));
}

TEST(WindowRecent, ClearingTheListRemovesThePicturesAndKeepsTheCase)
{
    forgetRecentCases();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("kept.angiopose"));
    SampleWindow w;
    save(w, path);
    EXPECT_GT(picturesStored(), 0);
    QMenu* menu = w.window.actions().recentMenu();
    ASSERT_FALSE(menu->actions().isEmpty());
    menu->actions().back()->trigger();
    QTest::qWait(0);   // rows are deleted once no event of theirs is in progress

    EXPECT_TRUE(recentCases().isEmpty());
    EXPECT_EQ(picturesStored(), 0);
    EXPECT_TRUE(recentButtons(w).isEmpty());
    EXPECT_TRUE(QFileInfo::exists(path));
}

TEST(WindowRecent, APictureGoesWhenItsCaseLeavesTheList)
{
    forgetRecentCases();
    const QTemporaryDir folder;
    SampleWindow w;
    const QString first = folder.filePath(QStringLiteral("first.angiopose"));
    save(w, first);
    ASSERT_FALSE(caseThumbnail(first).isNull());
    for (int i = 0; i < 30; ++i) {
        rememberCase(folder.filePath(QStringLiteral("%1.angiopose").arg(i)));
    }
    EXPECT_TRUE(caseThumbnail(first).isNull());
}

QWidget* childNamed(const OpenWindow& w, const QString& accessibleName)
{
    for (QWidget* widget : w.window.findChildren<QWidget*>()) {
        if (widget->accessibleName() == accessibleName && widget->isVisible()) {
            return widget;
        }
    }
    return nullptr;
}

TEST(WindowRecent, WhatIsMissingIsToldAndTheRestOpens)
{
    forgetRecentCases();
    const QTemporaryDir folder;
    const QString gone = folder.filePath(QStringLiteral("gone.angiopose"));
    const QString torn = folder.filePath(QStringLiteral("torn.angiopose"));
    {
        SampleWindow w;
        save(w, torn);
    }
    QFile saved(torn);
    ASSERT_TRUE(saved.open(QIODevice::ReadWrite));
    QByteArray content = saved.readAll();
    content.replace("run.dcm", "ran.dcm");
    saved.resize(0);
    saved.seek(0);
    saved.write(content);
    saved.close();
    rememberCase(gone);

    OpenWindow w;

    const auto labels = [&w] {
        QStringList texts;
        for (const QPushButton* button : recentButtons(w)) {
            texts << button->text() + (button->isEnabled() ? QString() : QStringLiteral(" -"));
        }
        return texts;
    };
    EXPECT_TRUE(test::waitFor([&] {
        return labels().mid(0, 2) == QStringList{QStringLiteral("gone.angiopose (missing) -"),
                                                 QStringLiteral("torn.angiopose (inputs missing)")};
    })) << labels().join(u'|').toStdString();
}

TEST(WindowRecent, CasesArePinnedRemovedAndSearched)
{
    forgetRecentCases();
    for (int i = 0; i < 8; ++i) {
        rememberCase(QStringLiteral("/nowhere/case%1.angiopose").arg(i));
    }
    OpenWindow w;
    QWidget* pin = nullptr;
    ASSERT_TRUE(test::waitFor(
        [&] { return (pin = childNamed(w, QStringLiteral("Pin case6.angiopose (missing)"))) != nullptr; }));
    QTest::mouseClick(pin, Qt::LeftButton);
    EXPECT_TRUE(test::waitFor([] { return recentCases().front().endsWith(QStringLiteral("case6.angiopose")); }));
    for (int i = 10; i < 60; ++i) {
        rememberCase(QStringLiteral("/nowhere/other%1.angiopose").arg(i));
    }
    EXPECT_TRUE(recentCases().front().endsWith(QStringLiteral("case6.angiopose"))) << "pinned ones stay";

    QWidget* remove = childNamed(w, QStringLiteral("Remove case7.angiopose (missing) from the list"));
    ASSERT_TRUE(remove);
    QTest::mouseClick(remove, Qt::LeftButton);
    EXPECT_TRUE(test::waitFor(
        [&] { return !childNamed(w, QStringLiteral("Remove case7.angiopose (missing) from the list")); }));

    QWidget* search = childNamed(w, QStringLiteral("Search recent cases"));
    ASSERT_TRUE(search);
    QTest::mouseClick(search, Qt::LeftButton);
    QTest::keyClicks(search, QStringLiteral("other55"));
    int shown = 0;
    for (const QPushButton* button : recentButtons(w)) {
        shown += button->isVisible() ? 1 : 0;
    }
    EXPECT_EQ(shown, 1);
    forgetRecentCases();
    EXPECT_EQ(recentCases().size(), 1) << "the pinned one";
}

TEST(WindowRecent, PicturesAreSwitchedOff)
{
    forgetRecentCases();
    const QTemporaryDir folder;
    {
        SampleWindow w;
        save(w, folder.filePath(QStringLiteral("seen.angiopose")));
        EXPECT_GT(picturesStored(), 0);
    }
    OpenWindow w;
    for (QCheckBox* box : w.window.findChildren<QCheckBox*>()) {
        if (box->text() == QStringLiteral("Thumbnails")) {
            QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
        }
    }
    EXPECT_TRUE(test::waitFor([] { return picturesStored() == 0; }));
    w.openSample();
    save(w, folder.filePath(QStringLiteral("unseen.angiopose")));
    EXPECT_EQ(picturesStored(), 0);
}

/// Simulates a drive that does not respond: the lookup of its case blocks until the test releases it.
TEST(WindowRecent, ADriveThatDoesNotAnswerKeepsNobodyWaiting)
{
    forgetRecentCases();
    OpenWindow w;   // its own lookup finds no cases yet
    rememberCase(QStringLiteral("/near/there.angiopose"));
    rememberCase(QStringLiteral("/hanging/drive.angiopose"));
    std::promise<void> answer;
    const std::shared_future<void> answered = answer.get_future().share();
    const auto check = [answered](const std::string& path, const std::string&) {
        if (path.starts_with("/hanging")) {
            answered.wait();
        }
        return RecentCaseStatus{CasePresence::Missing, {}};
    };
    QElapsedTimer clock;
    clock.start();
    RecentController recent(w.controller.document(), {w.window.actions(), w.window.welcome()}, check);
    EXPECT_LT(clock.elapsed(), 1000);

    const auto isKnown = [&w](const QString& label) {
        return std::ranges::any_of(recentButtons(w), [&](QPushButton* button) { return button->text() == label; });
    };
    EXPECT_TRUE(test::waitFor([&] { return isKnown(QStringLiteral("there.angiopose (missing)")); }));
    EXPECT_TRUE(isKnown(QStringLiteral("drive.angiopose"))) << "not known yet: it can be tried";

    answer.set_value();
    EXPECT_TRUE(test::waitFor([&] { return isKnown(QStringLiteral("drive.angiopose (missing)")); }));
    forgetRecentCases();
}

/// Compares gray values along a row near the top of the thumbnail, where burned-in names are.
TEST(WindowRecent, LettersInTheImageAreNotInThePicture)
{
    SampleWindow w;
    const core::Angiogram& run = *w.current().shown().angiogram;
    const QTemporaryDir folder;
    const auto store = [&](const QString& name, const QString& letters) {
        core::Angiogram written = run;
        core::ImageF& frame = written.frames[static_cast<std::size_t>(w.current().shown().frame)];
        const float white = *std::ranges::max_element(frame.pixels);
        QImage text(frame.width, frame.height, QImage::Format_Grayscale8);
        text.fill(Qt::black);
        QPainter painter(&text);
        painter.setRenderHint(QPainter::TextAntialiasing, false);
        QFont font;
        font.setPixelSize(frame.height / 16);
        font.setStyleStrategy(QFont::NoAntialias);
        painter.setFont(font);
        painter.setPen(Qt::white);
        painter.drawText(frame.width / 20, frame.height / 8, letters);
        painter.end();
        test::forEachPixel(frame.width, frame.height, [&](int x, int y) {
            if (qGray(text.pixel(x, y)) > 127) {
                frame.at(x, y) = white;
            }
        });
        core::Case pictured = w.current();
        pictured.shown().angiogram = std::make_shared<const core::Angiogram>(std::move(written));
        const QString path = folder.filePath(name);
        EXPECT_TRUE(storeCaseThumbnail(pictured, path));
        return caseThumbnail(path).convertToFormat(QImage::Format_Grayscale8);
    };
    const QImage named = store(QStringLiteral("named"), QStringLiteral("DOE JOHN 1950"));
    const QImage nameless = store(QStringLiteral("nameless"), {});
    int brighter = 0;
    test::forEachPixel(named.width(), named.height() / 6, [&](int x, int y) {
        brighter += qGray(named.pixel(x, y)) > qGray(nameless.pixel(x, y)) + 60 ? 1 : 0;
    });
    EXPECT_LT(brighter, 20) << "the name would cover some hundred pixels";
    forgetRecentCases();
}

}   // namespace
}   // namespace angiopose::app
