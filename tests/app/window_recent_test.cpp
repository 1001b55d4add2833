#include "app/files/case_pictures.h"
#include "app/files/recent_cases.h"
#include "tests/app/open_window.h"

#include <QDir>
#include <QMenu>
#include <QPainter>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace angiopose::app {
namespace {

using test::OpenWindow;

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
    w.controller.saving().saveTo(path);
    ASSERT_TRUE(QTest::qWaitFor([&w] { return !w.controller.saving().isSaving(); }, test::patienceMs));
}

TEST(WindowRecent, ASavedCaseShowsItsPictureOnTheFirstPage)
{
    forgetRecentCases();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("seen.angiopose"));
    {
        OpenWindow w;
        w.openSample();
        save(w, path);
    }
    const QImage picture = casePicture(path);
    ASSERT_FALSE(picture.isNull());
    EXPECT_EQ(picture.width(), casePictureWidthPx);

    OpenWindow w;
    const QList<QPushButton*> buttons = recentButtons(w);
    ASSERT_FALSE(buttons.isEmpty());
    EXPECT_EQ(buttons.front()->text(), QStringLiteral("seen.angiopose"));
    const QImage tile = buttons.front()->icon().pixmap(44, 44).toImage();
    QSet<QRgb> colors;
    for (int y = 0; y < tile.height(); ++y) {
        for (int x = 0; x < tile.width(); ++x) {
            colors.insert(tile.pixel(x, y));
        }
    }
    EXPECT_GT(colors.size(), 100) << "a picture, not a tile";
}

TEST(WindowRecent, ClearingTheListRemovesThePicturesAndKeepsTheCase)
{
    forgetRecentCases();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("kept.angiopose"));
    OpenWindow w;
    w.openSample();
    save(w, path);
    EXPECT_GT(picturesStored(), 0);
    QMenu* menu = w.window.actions().recentMenu();
    ASSERT_FALSE(menu->actions().isEmpty());
    menu->actions().back()->trigger();

    EXPECT_TRUE(recentCases().isEmpty());
    EXPECT_EQ(picturesStored(), 0);
    EXPECT_TRUE(recentButtons(w).isEmpty());
    EXPECT_TRUE(QFileInfo::exists(path));
}

TEST(WindowRecent, APictureGoesWhenItsCaseLeavesTheList)
{
    forgetRecentCases();
    const QTemporaryDir folder;
    OpenWindow w;
    w.openSample();
    const QString first = folder.filePath(QStringLiteral("first.angiopose"));
    save(w, first);
    ASSERT_FALSE(casePicture(first).isNull());
    for (int i = 0; i < 10; ++i) {
        rememberCase(folder.filePath(QStringLiteral("%1.angiopose").arg(i)));
    }
    EXPECT_TRUE(casePicture(first).isNull());
}

/// Grey values along a row of the picture's top, where names stand.
TEST(WindowRecent, LettersInTheImageAreNotInThePicture)
{
    OpenWindow w;
    w.openSample();
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
        for (int y = 0; y < frame.height; ++y) {
            for (int x = 0; x < frame.width; ++x) {
                if (qGray(text.pixel(x, y)) > 127) {
                    frame.at(x, y) = white;
                }
            }
        }
        core::Case pictured = w.current();
        pictured.shown().angiogram = std::make_shared<const core::Angiogram>(std::move(written));
        const QString path = folder.filePath(name);
        EXPECT_TRUE(storeCasePicture(pictured, path));
        return casePicture(path).convertToFormat(QImage::Format_Grayscale8);
    };
    const QImage named = store(QStringLiteral("named"), QStringLiteral("DOE JOHN 1950"));
    const QImage nameless = store(QStringLiteral("nameless"), {});
    int brighter = 0;
    for (int y = 0; y < named.height() / 6; ++y) {
        for (int x = 0; x < named.width(); ++x) {
            brighter += qGray(named.pixel(x, y)) > qGray(nameless.pixel(x, y)) + 60 ? 1 : 0;
        }
    }
    EXPECT_LT(brighter, 20) << "the name would cover some hundred pixels";
    forgetRecentCases();
}

}   // namespace
}   // namespace angiopose::app