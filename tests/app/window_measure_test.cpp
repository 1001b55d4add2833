#include "core/measuring/measure_image.h"
#include "tests/app/open_window.h"
#include "tests/support/for_each.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"
#include "ui/places/side_by_side.h"

#include <QComboBox>
#include <QImage>
#include <QTreeWidget>

namespace angiopose::app {
namespace {

using core::MeasurementPlane;

class WindowMeasure : public ::testing::Test {
protected:
    ui::AngiogramView& view() { return w.window.angiogramView(); }
    QPoint at(double u, double v) { return view().widgetFromImage({u, v}).toPoint(); }
    Eigen::Vector2d pixelAt(const QPoint& place) { return view().imageFromWidget(place); }
    void click(double u, double v)
    {
        QTest::mouseMove(&view(), at(u, v));
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::NoModifier, at(u, v));
    }
    void dragFrom(const QPoint& from, const QPoint& to)
    {
        QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
        QTest::mouseMove(&view(), (from + to) / 2);
        QTest::mouseMove(&view(), to);
        QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, to);
    }
    void drawLength(double u0, double v0, double u1, double v1) { dragFrom(at(u0, v0), at(u1, v1)); }
    void waitALittle() { QTest::qWait(QApplication::doubleClickInterval() + 20); }   // avoids double clicks

    const std::vector<core::ImageMeasurement>& measurements() { return w.current().shown().measurements; }
    QTreeWidget& list() { return *w.window.measure().findChild<QTreeWidget*>(); }
    core::ImageMeasurementResult measured(std::size_t place)
    {
        return core::measureImage(measurements()[place], {w.current().shown(), w.current().vessels.tree.get()}).value();
    }

    test::SampleWindow w;
};

TEST_F(WindowMeasure, ALengthIsDrawnListedAndUndone)
{
    const int steps = w.history().count();
    w.press(Qt::Key_D, Qt::ShiftModifier);
    ASSERT_TRUE(w.window.actions()[ui::Command::MeasureLength]->isChecked());
    EXPECT_FALSE(w.window.measure().isFolded());
    const QPoint from = at(150, 200);
    const QPoint to = at(250, 230);
    dragFrom(from, to);
    ASSERT_EQ(measurements().size(), 1U);
    EXPECT_EQ(w.history().count(), steps + 1);
    EXPECT_EQ(measurements()[0].frame, w.current().shown().frame);
    EXPECT_EQ(measurements()[0].plane, MeasurementPlane::Vessels);
    EXPECT_LT((measurements()[0].pixels[0] - pixelAt(from)).norm(), 1e-9);
    EXPECT_LT((measurements()[0].pixels[1] - pixelAt(to)).norm(), 1e-9);

    const auto camera = core::cameraOf(w.current().shown()).value();
    const double depthMm =
        (w.current().shown().cameraFromPatient * core::centroidInPatient(*w.current().vessels.tree)).z();
    const Eigen::Vector2d across = pixelAt(to) - pixelAt(from);
    EXPECT_NEAR(measured(0).value.value, depthMm * std::hypot(across.x() / camera.fx, across.y() / camera.fy), 1e-9);
    ASSERT_EQ(view().marks().size(), 1U);
    EXPECT_NE(view().marks()[0].label.find("mm at the vessels"), std::string::npos) << view().marks()[0].label;
    ASSERT_EQ(list().topLevelItemCount(), 1);
    EXPECT_EQ(list().topLevelItem(0)->text(1).toStdString(), view().marks()[0].label);

    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(measurements().empty());
    EXPECT_TRUE(view().marks().empty());
    EXPECT_EQ(list().topLevelItemCount(), 0);
    w.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(measurements().size(), 1U);
}

TEST_F(WindowMeasure, AnglesAndAreasByClicks)
{
    w.press(Qt::Key_G, Qt::ShiftModifier);
    click(300, 200);
    click(200, 200);
    EXPECT_TRUE(measurements().empty());
    click(200, 300);
    ASSERT_EQ(measurements().size(), 1U);
    EXPECT_EQ(measurements()[0].kind, core::MeasurementKind::Angle);
    EXPECT_NEAR(measured(0).value.value, 90.0, 1.0);

    w.press(Qt::Key_O, Qt::ShiftModifier);
    waitALittle();
    click(100, 100);
    click(160, 100);
    click(160, 140);
    EXPECT_EQ(measurements().size(), 1U);
    QTest::keyClick(&view(), Qt::Key_Backspace);
    click(160, 160);
    click(100, 160);
    QTest::keyClick(&view(), Qt::Key_Return);
    ASSERT_EQ(measurements().size(), 2U);
    EXPECT_EQ(measurements()[1].pixels.size(), 4U);
    EXPECT_STREQ(measured(1).value.unit, "mm²");

    waitALittle();
    click(300, 300);
    click(360, 300);
    QTest::mouseDClick(&view(), Qt::LeftButton, Qt::NoModifier, at(330, 350));
    EXPECT_EQ(measurements().size(), 2U) << "a double click's own first click sets a point, two are no area";
    click(330, 350);
    click(300, 300);   // closes the polygon at its first point
    ASSERT_EQ(measurements().size(), 3U);
    EXPECT_EQ(measurements()[2].pixels.size(), 3U);
}

TEST_F(WindowMeasure, EscTakesBackWhatIsUnderWayThenEndsTheMode)
{
    w.press(Qt::Key_G, Qt::ShiftModifier);
    click(300, 200);
    click(200, 200);
    QTest::keyClick(&view(), Qt::Key_Escape);
    EXPECT_TRUE(w.window.actions()[ui::Command::MeasureAngle]->isChecked());
    waitALittle();
    click(200, 300);
    EXPECT_TRUE(measurements().empty()) << "a new angle begins";
    QTest::keyClick(&view(), Qt::Key_Escape);
    QTest::keyClick(&view(), Qt::Key_Escape);
    EXPECT_FALSE(w.window.actions()[ui::Command::MeasureAngle]->isChecked());
    EXPECT_TRUE(measurements().empty());
}

TEST_F(WindowMeasure, PointsAreMovedAndMeasurementsRenamedAndRemoved)
{
    w.press(Qt::Key_D, Qt::ShiftModifier);
    drawLength(150, 200, 250, 200);
    drawLength(150, 300, 250, 300);
    ASSERT_EQ(measurements().size(), 2U);
    const double before = measured(0).value.value;
    dragFrom(at(250, 200), at(350, 200));
    ASSERT_EQ(measurements().size(), 2U) << "the point was taken, no line drawn";
    EXPECT_NEAR(measured(0).value.value / before, 2.0, 0.03);

    list().setFocus();
    list().setCurrentItem(list().topLevelItem(0));
    QTest::keyClick(&list(), Qt::Key_F2);
    auto* editor = list().findChild<QLineEdit*>();
    ASSERT_TRUE(editor);
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("neck"));
    QTest::keyClick(editor, Qt::Key_Return);
    EXPECT_TRUE(test::waitFor([&] { return measurements()[0].name == "neck"; }));
    EXPECT_EQ(view().marks()[0].label.rfind("neck ", 0), 0U);
    EXPECT_TRUE(view().marks()[0].isSelected);

    QTest::keyClick(&list(), Qt::Key_Delete);
    ASSERT_EQ(measurements().size(), 1U);
    EXPECT_NEAR(measurements()[0].pixels[0].y(), 300.0, 1.0);
    w.history().undo();
    EXPECT_EQ(measurements()[0].name, "neck");
}

TEST_F(WindowMeasure, ThePlaneIsChosenAndValuesFollowThePose)
{
    w.press(Qt::Key_D, Qt::ShiftModifier);
    drawLength(150, 200, 250, 200);
    const double atVessels = measured(0).value.value;
    w.press(Qt::Key_Escape);
    w.press(Qt::Key_N);
    QTest::keyClick(&view(), Qt::Key_PageUp, Qt::ShiftModifier);   // 10 mm away from the source
    EXPECT_GT(measured(0).value.value, atVessels);
    EXPECT_EQ(view().marks()[0].label, list().topLevelItem(0)->text(1).toStdString());

    list().setCurrentItem(list().topLevelItem(0));
    auto* plane = w.window.measure().findChild<QComboBox*>();
    plane->setFocus();
    QTest::keyClick(plane, Qt::Key_End);
    QTest::keyClick(plane, Qt::Key_Up);   // the entry before the typed scale
    EXPECT_EQ(measurements()[0].plane, MeasurementPlane::Pixels);
    EXPECT_NEAR(measured(0).value.value, 100.0, 1.0);
    EXPECT_NE(view().marks()[0].label.find("px"), std::string::npos);
}

TEST_F(WindowMeasure, IsSeenOnItsFrameAloneAndComesBackWithTheCase)
{
    w.press(Qt::Key_D, Qt::ShiftModifier);
    drawLength(150, 200, 250, 200);
    ASSERT_EQ(view().marks().size(), 1U);
    const int frame = w.current().shown().frame;
    QTest::keyClick(&view(), frame > 0 ? Qt::Key_Up : Qt::Key_Down);
    ASSERT_NE(w.current().shown().frame, frame);
    EXPECT_TRUE(view().marks().empty());
    EXPECT_EQ(list().topLevelItemCount(), 1);
    QTest::keyClick(&view(), frame > 0 ? Qt::Key_Down : Qt::Key_Up);
    EXPECT_EQ(view().marks().size(), 1U);

    const test::TemporaryFolder folder;
    const QString path = QString::fromStdString(folder.file("measured.angiopose"));
    w.controller.saveController().saveTo(path);
    ASSERT_TRUE(test::waitFor([&] { return !w.controller.document().isModified(); }));
    const auto saved = w.current().shown().measurements;
    w.controller.document().replace({}, {});
    EXPECT_TRUE(view().marks().empty());
    w.drop({path});
    EXPECT_EQ(measurements(), saved);
    EXPECT_EQ(view().marks().size(), 1U);
}

TEST_F(WindowMeasure, TheExportedPictureAndTableShowIt)
{
    const test::TemporaryFolder folder;
    const auto exported = [&](const char* name) {
        const QString path = QString::fromStdString(folder.file(name));
        w.controller.exportController().exportOverlay({1024, ui::Toggle::Off, ui::Toggle::Off}, path);
        EXPECT_TRUE(test::waitFor([&path] { return !QImage(path).isNull(); }));
        return QImage(path);
    };
    const QImage plain = exported("plain.png");
    w.press(Qt::Key_D, Qt::ShiftModifier);
    drawLength(100, 380, 400, 380);
    const QImage marked = exported("marked.png");
    ASSERT_EQ(plain.size(), marked.size());
    const double scale = static_cast<double>(marked.width()) / w.current().shown().angiogram->width();
    const QPoint middle = (QPointF(250.5, measurements()[0].pixels[0].y() + 0.5) * scale).toPoint();
    EXPECT_GT(qGray(marked.pixel(middle)), 150) << "the line is bright";
    EXPECT_NE(plain.pixel(middle), marked.pixel(middle));
    int changed = 0;
    test::forEachPixel(plain.width(), plain.height(),
                       [&](int x, int y) { changed += plain.pixel(x, y) != marked.pixel(x, y) ? 1 : 0; });
    EXPECT_LT(changed, plain.width() * plain.height() / 20) << "nothing else is drawn over";

    w.window.actions()[ui::Command::ExportMeasurements]->trigger();
    w.saveAs(QString::fromStdString(folder.file("m.csv")));
    ASSERT_TRUE(test::waitFor([&] { return !test::readText(folder.file("m.csv")).empty(); }));
    EXPECT_NE(test::readText(folder.file("m.csv")).find("\n1,"), std::string::npos);
}

TEST_F(WindowMeasure, WithoutAnImageNothingIsMeasured)
{
    w.controller.document().replace({}, {});
    w.window.actions()[ui::Command::MeasureLength]->trigger();
    EXPECT_FALSE(w.window.actions()[ui::Command::MeasureLength]->isChecked());
    w.window.actions()[ui::Command::ExportMeasurements]->trigger();
    EXPECT_FALSE(w.window.findChild<QFileDialog*>());
}

TEST_F(WindowMeasure, ARunLocksItAndLosesNothing)
{
    w.press(Qt::Key_D, Qt::ShiftModifier);
    w.controller.document().setLocked(true);
    drawLength(150, 200, 250, 200);
    EXPECT_TRUE(measurements().empty());
    w.controller.document().setLocked(false);
    drawLength(150, 200, 250, 200);
    EXPECT_EQ(measurements().size(), 1U);
}

}   // namespace
}   // namespace angiopose::app
