#include "io/case/case_file.h"
#include "tests/app/open_window.h"
#include "tests/support/temporary_folder.h"

#include <QScreen>
#include <QSplitter>

namespace angiopose::app {
namespace {

using test::OpenWindow;

TEST(WindowLayout, ShowsTheImageAloneAndTheColumnsAgain)
{
    OpenWindow w;
    w.openSample();
    const int before = w.window.angiogramView().width();
    w.press(Qt::Key_4);
    QApplication::processEvents();
    EXPECT_FALSE(w.window.branches().isVisible());
    EXPECT_FALSE(w.window.result().isVisible());
    EXPECT_GT(w.window.angiogramView().width(), before + 300);
    w.press(Qt::Key_4);
    QApplication::processEvents();
    EXPECT_TRUE(w.window.branches().isVisible());
    EXPECT_EQ(w.window.angiogramView().width(), before);
}

ui::Section* sectionNamed(ui::MainWindow& window, const QString& name)
{
    return window.findChild<ui::Section*>(name);
}

TEST(WindowLayout, RemembersWhatIsFolded)
{
    QByteArray layout;
    {
        OpenWindow w;
        ui::Section* residuals = sectionNamed(w.window, QStringLiteral("residuals"));
        ASSERT_TRUE(residuals);
        EXPECT_FALSE(residuals->isFolded());
        residuals->setFolded(true);
        layout = w.window.layoutState();
    }
    OpenWindow again;
    again.window.restoreLayout(layout);
    EXPECT_TRUE(sectionNamed(again.window, QStringLiteral("residuals"))->isFolded());
    EXPECT_FALSE(sectionNamed(again.window, QStringLiteral("convergence"))->isFolded());
    again.window.restoreLayout(QByteArray("nonsense"));   // leaves all as it is
    EXPECT_TRUE(sectionNamed(again.window, QStringLiteral("residuals"))->isFolded());
}

TEST(WindowLayout, IsWholeOnASmallerScreenThanItWasLeftOn)
{
    QByteArray layout;
    const QRect room = QApplication::primaryScreen()->availableGeometry();
    {
        OpenWindow w;
        w.window.setGeometry(40, 40, room.width() + 300, room.height() + 200);
        layout = w.window.layoutState();
    }
    OpenWindow again;
    again.window.restoreLayout(layout);
    QApplication::processEvents();
    EXPECT_LE(again.window.width(), room.width());
    EXPECT_LE(again.window.height(), room.height());
    EXPECT_TRUE(room.contains(again.window.geometry().topLeft()));
}

TEST(WindowLayout, RemembersTheBrightnessOfASeries)
{
    OpenWindow w;
    w.openSample();
    QApplication::processEvents();
    const double automatic = w.window.angiogramView().shownRange().window();
    w.press(Qt::Key_8);
    ASSERT_NEAR(w.window.angiogramView().shownRange().window(), 0.5 * automatic, 1e-6 * automatic);

    w.controller.document().replace({}, {});   // another day
    w.openSample();
    QApplication::processEvents();

    EXPECT_NEAR(w.window.angiogramView().shownRange().window(), 0.5 * automatic, 1e-6 * automatic);
}

TEST(WindowLayout, StartsWithTheSameBrightnessWhicheverFrameACaseWasLeftAt)
{
    OpenWindow w;
    w.openSample();
    QApplication::processEvents();
    const core::DisplayRange automatic = w.window.angiogramView().shownRange();
    w.press(Qt::Key_Home);   // to a frame without contrast
    ASSERT_EQ(w.current().shown().frame, 0);
    const test::TemporaryFolder folder;
    const std::string path = folder.file("case.angiopose");
    ASSERT_TRUE(io::saveCase(w.current(), path));
    OpenWindow again;
    again.drop({QString::fromStdString(path)});
    QApplication::processEvents();
    EXPECT_EQ(again.window.angiogramView().shownRange().window(), automatic.window());
    EXPECT_EQ(again.window.angiogramView().shownRange().level(), automatic.level());
}

}   // namespace
}   // namespace angiopose::app