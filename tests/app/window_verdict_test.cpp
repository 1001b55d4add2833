#include "app/document/edit_case.h"
#include "core/messages/messages.h"
#include "tests/app/open_window.h"
#include "tests/support/for_each.h"
#include "tests/support/temporary_folder.h"
#include "ui/views/verdict_chip.h"

#include <QGraphicsEffect>

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;
using ui::VerdictTone;

ui::VerdictChip& chipOf(OpenWindow& w)
{
    return *w.window.angiogramView().findChild<ui::VerdictChip*>();
}

void distrust(OpenWindow& w)
{
    std::vector<core::View> views = w.current().views;
    core::RegistrationResult& result = *views[w.current().shownView].result;
    result.trustworthy = false;
    result.warnings = {core::messages::depthUndetermined(), core::messages::alternativePoseFits()};
    w.controller.document().push(std::make_unique<ChangeViews>(
        w.controller.document(), ChangeViews::Values{std::move(views)}, [] { return QStringLiteral("distrust"); }));
    w.waitForJudgement();
    QApplication::processEvents();
}

bool isInSight(OpenWindow& w, const QWidget& widget)
{
    return widget.isVisible() && widget.visibleRegion().boundingRect().size() == widget.size() &&
           w.window.rect().contains(QRect(widget.mapTo(&w.window, QPoint(0, 0)), widget.size()));
}

int countOf(OpenWindow& w, const ui::Color& color)
{
    const QImage shot = w.window.angiogramView().grab().toImage();
    int count = 0;
    test::forEachPixel(shot.width(), shot.height(), [&](int x, int y) {
        const QRgb pixel = shot.pixel(x, y);
        count += std::abs(qRed(pixel) - color.red) + std::abs(qGreen(pixel) - color.green) +
                             std::abs(qBlue(pixel) - color.blue) <
                         40
                     ? 1
                     : 0;
    });
    return count;
}

/// Share of the chip's pixels in a screenshot of the window that have the color of its tone.
double shareOfTone(OpenWindow& w, const ui::Color& tone)
{
    const QImage shot = w.window.grab().toImage();
    const double ratio = shot.devicePixelRatio();
    const QWidget& chip = chipOf(w);
    const QPoint at = chip.mapTo(&w.window, QPoint(0, 0));
    const QRect place(QPoint(qRound(at.x() * ratio), qRound(at.y() * ratio)), chip.size() * ratio);
    int count = 0;
    test::forEachPixel({place.left(), place.top()}, {place.right() + 1, place.bottom() + 1}, [&](int x, int y) {
        const QColor pixel = shot.pixelColor(x, y);
        count += std::abs(pixel.red() - tone.red) + std::abs(pixel.green() - tone.green) +
                             std::abs(pixel.blue() - tone.blue) <
                         40
                     ? 1
                     : 0;
    });
    return static_cast<double>(count) / (1.0 * place.width() * place.height());
}

TEST(WindowVerdict, IsOnTheImageAtEverySizeOfTheWindowAfterGoodDoubtfulAndFailedFits)
{
    const ui::Palette& tones = ui::palette(ui::ThemeMode::Dark);
    SampleWindow w;
    const auto expectInSight = [&](VerdictTone tone, const ui::Color& color) {
        for (const QSize& size : {QSize(900, 560), QSize(1280, 720), QSize(1920, 1080)}) {
            w.window.resize(size / w.window.devicePixelRatio());
            QApplication::processEvents();
            ASSERT_TRUE(isInSight(w, chipOf(w))) << size.width();
            EXPECT_EQ(chipOf(w).tone(), tone);
            EXPECT_GT(shareOfTone(w, color), 0.03) << size.width() << " px, " << chipOf(w).fullText().toStdString();
            w.window.result().setFocus();
        }
    };
    expectInSight(VerdictTone::Doubtful, tones.attention);   // initial pose
    w.registerVessels();
    w.waitForJudgement();
    ASSERT_TRUE(w.current().shown().result->trustworthy);
    expectInSight(VerdictTone::Good, tones.fine);
    distrust(w);
    expectInSight(VerdictTone::Bad, tones.error);
    EXPECT_TRUE(chipOf(w).fullText().startsWith(QStringLiteral("NOT RELIABLE")));
}

TEST(WindowVerdict, IsInSightInThePanelAfterARunWithoutScrolling)
{
    SampleWindow w;
    w.window.resize(QSize(1280, 720) / w.window.devicePixelRatio());
    w.registerVessels();
    w.waitForJudgement();
    QTest::qWait(50);   // the column scrolls after its layout
    const auto number = [&]() -> QLabel* {
        for (QLabel* label : w.window.result().findChildren<QLabel*>()) {
            if (label->property("role").toString().startsWith(QStringLiteral("bigNumber"))) {
                return label;
            }
        }
        return nullptr;
    };
    ASSERT_TRUE(number());
    EXPECT_TRUE(isInSight(w, *number()));
    EXPECT_EQ(number()->property("role").toString(), QStringLiteral("bigNumber"));
    distrust(w);
    EXPECT_EQ(number()->property("role").toString(), QStringLiteral("bigNumberDoubtful"));
    QString red;
    for (QLabel* label : w.window.result().findChildren<QLabel*>()) {
        red += label->isVisible() && label->property("role") == QStringLiteral("errorBox") ? label->text() : QString();
    }
    EXPECT_TRUE(red.startsWith(QStringLiteral("NOT RELIABLE"))) << red.toStdString();
}

TEST(WindowVerdict, OfAPoseThatIsLookedAtIsNotThatOfTheResult)
{
    SampleWindow w;
    w.press(Qt::Key_K);
    w.registerVessels();
    w.waitForJudgement();
    QApplication::processEvents();
    QTest::qWait(1000);   // residuals and texts of the whole tree arrive later
    const QString found = chipOf(w).fullText();
    ASSERT_EQ(chipOf(w).tone(), VerdictTone::Good);
    const int onVessels = countOf(w, ui::residualColor(0.0));
    const int above = countOf(w, ui::residualColorAboveScale());
    ASSERT_GT(onVessels, 100);

    w.press(Qt::Key_Y);   // the initial pose, off by millimeters
    QTest::qWait(1000);
    EXPECT_EQ(chipOf(w).tone(), VerdictTone::Doubtful);
    EXPECT_TRUE(chipOf(w).fullText().startsWith(QStringLiteral("Preview"))) << chipOf(w).fullText().toStdString();
    EXPECT_TRUE(chipOf(w).fullText().contains(QStringLiteral("mm")));
    EXPECT_LT(countOf(w, ui::residualColor(0.0)), onVessels / 2) << "coloured by what is shown";
    EXPECT_GT(countOf(w, ui::residualColorAboveScale()), above + 100) << "and the bar of colours stays";
    EXPECT_TRUE(w.window.result().findChild<QGraphicsEffect*>()) << "the numbers beside it are dimmed";

    w.press(Qt::Key_Y);
    QTest::qWait(1000);
    EXPECT_EQ(chipOf(w).fullText().toStdString(), found.toStdString());
    EXPECT_EQ(countOf(w, ui::residualColor(0.0)), onVessels);
    EXPECT_FALSE(w.window.result().findChild<QGraphicsEffect*>());
}

TEST(WindowVerdict, StaysOutOfSightInABlindTrial)
{
    SampleWindow w;
    ASSERT_TRUE(chipOf(w).isVisible());
    const test::TemporaryFolder folder;
    w.controller.poses().blindTrial().start({.observer = QStringLiteral("A"),
                                             .seed = 1,
                                             .rangeMm = 5.0,
                                             .rangeDeg = 3.0,
                                             .logPath = QString::fromStdString(folder.file("log.csv"))});
    QApplication::processEvents();
    EXPECT_FALSE(chipOf(w).isVisible());
    w.press(Qt::Key_F);
    QApplication::processEvents();
    EXPECT_FALSE(chipOf(w).isVisible());
}

}   // namespace
}   // namespace angiopose::app
