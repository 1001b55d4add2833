#include "tests/app/open_window.h"

#include "ui/dialogs/angle_dialog.h"
#include "ui/plots/angle_map_plot.h"

#include <QCheckBox>
#include <QLabel>

namespace angiopose::app {
namespace {

using test::OpenWindow;

/// The sample with the gantry angles dialog open for one branch.
struct AnglesWindow : OpenWindow {
    AnglesWindow()
    {
        openSample();
        controller.branches().select({current().vessels.tree->branches[2].id});
        press(Qt::Key_U, Qt::ShiftModifier);
        EXPECT_TRUE(test::waitFor([this] { return !dialogs("angleDialog").isEmpty(); }));
    }
    ui::AngleDialog& dialog() { return *qobject_cast<ui::AngleDialog*>(dialogs("angleDialog").front()); }
    ui::AngleMapPlot& plot() { return *dialog().findChild<ui::AngleMapPlot*>(); }
    QPushButton* button(const QString& start)
    {
        for (QPushButton* each : dialog().findChildren<QPushButton*>()) {
            if (each->isVisible() && each->text().startsWith(start)) {
                return each;
            }
        }
        return nullptr;
    }
    QString words()
    {
        QString all;
        for (const QLabel* label : dialog().findChildren<QLabel*>()) {
            all += label->isVisible() ? label->text() + QLatin1Char('\n') : QString();
        }
        return all;
    }
    void waitForMap()
    {
        EXPECT_TRUE(test::waitFor([this] { return button(QStringLiteral("1 ")) != nullptr; }));
    }
};

TEST(WindowGantryAngles, ProposesAnglesAndShowsTheVesselsFromThose)
{
    AnglesWindow w;
    w.waitForMap();
    const QString best = w.button(QStringLiteral("1 "))->text().mid(4).trimmed();
    EXPECT_TRUE(w.words().contains(best + QStringLiteral(": foreshortening"))) << w.words().toStdString();

    QTest::mouseClick(w.button(QStringLiteral("Current")), Qt::LeftButton);
    EXPECT_FALSE(w.words().contains(best + QStringLiteral(": foreshortening")));
    const QString now = w.words();
    w.plot().setFocus();
    QTest::keyClick(&w.plot(), Qt::Key_Right, Qt::ShiftModifier);
    const QString beside = w.words();
    EXPECT_NE(beside, now);
    QTest::mouseClick(&w.plot(), Qt::LeftButton, {}, {3, w.plot().height() - 3});
    EXPECT_TRUE(w.words().contains(QStringLiteral("RAO 90° · CAU 40°"))) << w.words().toStdString();
}

TEST(WindowGantryAngles, FollowsTheSelectionAndSaysWhatItNeeds)
{
    AnglesWindow w;
    w.waitForMap();
    const QString first = w.words();
    w.controller.branches().select({});
    EXPECT_TRUE(w.words().contains(QStringLiteral("Select one branch"))) << w.words().toStdString();
    EXPECT_EQ(w.button(QStringLiteral("1 ")), nullptr);
    w.controller.branches().select({w.current().vessels.tree->branches[4].id});
    w.waitForMap();
    EXPECT_NE(w.words(), first);
}

TEST(WindowGantryAngles, KeepsToWhatTheGantryReachesAndRemembersIt)
{
    {
        AnglesWindow w;
        w.waitForMap();
        auto fields = w.dialog().findChildren<QLineEdit*>();
        ASSERT_EQ(fields.size(), 4);
        for (QLineEdit* field : fields) {
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, QStringLiteral("10"));
            QTest::keyClick(field, Qt::Key_Return);
        }
        EXPECT_DOUBLE_EQ(w.dialog().limits().primary.toDeg, 10.0);
        const auto isWithin = [&w] {   // the map of the new request has arrived
            QTest::mouseClick(&w.plot(), Qt::LeftButton, {}, {w.plot().width() - 3, 3});
            return w.words().contains(QStringLiteral("LAO 10° · CRA 10°"));
        };
        EXPECT_TRUE(test::waitFor(isWithin)) << w.words().toStdString();
    }
    AnglesWindow again;
    EXPECT_DOUBLE_EQ(again.dialog().limits().secondary.fromDeg, -10.0);
    for (const Setting<double>* each :
         {&settings::gantryRao, &settings::gantryLao, &settings::gantryCaudal, &settings::gantryCranial}) {
        each->write(each->fallback);
    }
}

TEST(WindowGantryAngles, LooksAtTheTakeOffAlone)
{
    AnglesWindow w;
    w.waitForMap();
    const QString whole = w.words();
    auto* box = w.dialog().findChild<QCheckBox*>();
    QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
    w.waitForMap();
    EXPECT_TRUE(test::waitFor([&] { return w.words() != whole; }));
}

}   // namespace
}   // namespace angiopose::app
