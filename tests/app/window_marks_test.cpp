#include "core/measuring/target_points.h"
#include "core/vessel/tree_position.h"
#include "tests/app/open_window.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"
#include "ui/slices/slice_model.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLineEdit>
#include <QTreeWidget>

namespace angiopose::app {
namespace {

class WindowMarks : public ::testing::Test {
protected:
    ui::AngiogramView& view() { return w.window.angiogramView(); }
    QPoint at(const Eigen::Vector2d& pixel) { return view().widgetFromImage(pixel).toPoint(); }
    void click(const QPoint& place)
    {
        QTest::mouseMove(&view(), place);
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::NoModifier, place);
    }
    void dragFrom(const QPoint& from, const QPoint& to)
    {
        QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
        QTest::mouseMove(&view(), (from + to) / 2);
        QTest::mouseMove(&view(), to);
        QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, to);
    }
    const core::VesselTree& tree() { return *w.current().vessels.tree; }
    Eigen::Vector3d middle()
    {
        const auto& longest = *std::ranges::max_element(tree().branches, {}, &core::VesselBranch::lengthMm);
        return longest.pointsInPatient[longest.pointsInPatient.size() / 2];
    }
    QPoint onScreen(const Eigen::Vector3d& point) { return view().positionOf(point)->toPoint(); }
    const std::vector<core::VesselMark>& marks() { return w.current().vessels.marks; }
    QTreeWidget& list() { return *w.window.marks().findChild<QTreeWidget*>(); }
    void setPoint()
    {
        w.press(Qt::Key_X, Qt::ShiftModifier);
        click(onScreen(middle()));
    }
    bool isDrawn(const std::string& label)
    {
        return std::ranges::any_of(view().placedMarks(), [&](const ui::ImageMark& mark) {
            return mark.label.find(label) != std::string::npos;
        });
    }

    test::SampleWindow w;
};

TEST_F(WindowMarks, ACheckPointIsSetOnTheVesselsListedAndUndone)
{
    const int steps = w.history().count();
    setPoint();
    EXPECT_FALSE(w.window.marks().isFolded());
    ASSERT_EQ(marks().size(), 1U);
    EXPECT_EQ(w.history().count(), steps + 1);
    EXPECT_EQ(marks()[0].name, "Target point 1");
    EXPECT_LT((*core::nearestPointOnTree(tree(), marks()[0].pointInPatient) - marks()[0].pointInPatient).norm(), 1e-9);
    const QPoint away = onScreen(marks()[0].pointInPatient) - onScreen(middle());
    EXPECT_LT(away.manhattanLength(), 4);
    ASSERT_EQ(list().topLevelItemCount(), 1);
    EXPECT_TRUE(isDrawn("Target point 1"));
    ASSERT_EQ(w.window.slices().points().at(ui::SliceMarkKind::Place).size(), 1U);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(marks().empty());
    EXPECT_TRUE(view().placedMarks().empty());
    EXPECT_EQ(list().topLevelItemCount(), 0);
    w.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(marks().size(), 1U);
}

TEST_F(WindowMarks, BesideTheVesselsNothingIsSet)
{
    w.press(Qt::Key_X, Qt::ShiftModifier);
    click(at({2.0, 2.0}));
    EXPECT_TRUE(marks().empty());
}

TEST_F(WindowMarks, TheErrorIsThatOfAPoseMovedByHand)
{
    setPoint();
    w.press(Qt::Key_S, Qt::ShiftModifier);
    const QPoint seen = onScreen(marks()[0].pointInPatient);
    click(seen);
    ASSERT_EQ(w.current().shown().observations.size(), 1U);
    EXPECT_EQ(w.current().shown().observations[0].markId, marks()[0].id);
    EXPECT_LT(core::evaluateTargetPoints(w.current())[0].views[0].error.value().mm, 0.3) << "a click is a pixel";

    w.press(Qt::Key_Escape);
    w.press(Qt::Key_N);
    QTest::keyClick(&view(), Qt::Key_Right, Qt::ShiftModifier);   // 10 mm
    const double mm = core::evaluateTargetPoints(w.current())[0].views[0].error.value().mm;
    EXPECT_NEAR(mm, 10.0, 0.5);
    EXPECT_TRUE(list().topLevelItem(0)->text(1).contains(QStringLiteral("error 10")))
        << list().topLevelItem(0)->text(1).toStdString();
    EXPECT_TRUE(isDrawn("error 10"));
}

TEST_F(WindowMarks, RingsTakeTheirWidthFromTheBranch)
{
    w.press(Qt::Key_Q, Qt::ShiftModifier);
    click(onScreen(middle()));
    ASSERT_EQ(marks().size(), 1U);
    EXPECT_EQ(marks()[0].kind, core::VesselMarkKind::OstiumRing);
    const auto place = *core::nearestPosition(tree(), marks()[0].pointInPatient);
    EXPECT_NEAR(marks()[0].radiusMm, *core::radiusAt(tree(), place), 1e-9);
    EXPECT_GT(std::abs(marks()[0].normal.dot(core::directionAt(tree(), place))), 0.999);
    ASSERT_EQ(view().placedMarks().size(), 1U);
    EXPECT_EQ(view().placedMarks()[0].shape, ui::MarkShape::Outline);
}

TEST_F(WindowMarks, APointOf3dOrASliceIsTakenWhileTheModeIsOn)
{
    emit w.window.pointPicked(middle());
    EXPECT_TRUE(marks().empty());
    w.press(Qt::Key_X, Qt::ShiftModifier);
    emit w.window.pointPicked(middle());
    ASSERT_EQ(marks().size(), 1U);
    EXPECT_LT((marks()[0].pointInPatient - middle()).norm(), 1e-6);
    emit w.window.pointPicked(middle() + Eigen::Vector3d(300, 0, 0));
    EXPECT_EQ(marks().size(), 1U);
}

TEST_F(WindowMarks, MarksAreMovedRenamedAndRemovedInOneStep)
{
    setPoint();
    const Eigen::Vector3d before = marks()[0].pointInPatient;
    const Eigen::Vector3d other = tree().branches.front().pointsInPatient.front();
    dragFrom(onScreen(before), onScreen(other));
    ASSERT_EQ(marks().size(), 1U);
    EXPECT_LT((onScreen(marks()[0].pointInPatient) - onScreen(other)).manhattanLength(), 6);
    w.press(Qt::Key_S, Qt::ShiftModifier);
    click(at({100, 100}));
    ASSERT_EQ(w.current().shown().observations.size(), 1U);

    list().setFocus();
    list().setCurrentItem(list().topLevelItem(0));
    QTest::keyClick(&list(), Qt::Key_F2);
    auto* editor = list().findChild<QLineEdit*>();
    ASSERT_TRUE(editor);
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("LAD fork"));
    QTest::keyClick(editor, Qt::Key_Return);
    EXPECT_TRUE(test::waitFor([&] { return marks()[0].name == "LAD fork"; }));
    EXPECT_TRUE(isDrawn("LAD fork"));

    QTest::keyClick(&list(), Qt::Key_Delete);
    EXPECT_TRUE(marks().empty());
    EXPECT_TRUE(w.current().shown().observations.empty());
    w.history().undo();
    EXPECT_EQ(marks()[0].name, "LAD fork");
    EXPECT_EQ(w.current().shown().observations.size(), 1U);
}

TEST_F(WindowMarks, ArrowsAndTextsAreDrawnWrittenAndUndone)
{
    w.press(Qt::Key_W, Qt::ShiftModifier);
    dragFrom(at({100, 120}), at({180, 200}));
    auto* line = view().findChild<QLineEdit*>();
    ASSERT_TRUE(line);
    EXPECT_TRUE(w.current().shown().annotations.empty());
    line->setText(QStringLiteral("  Engstelle 狭窄 😀 "));
    QTest::keyClick(line, Qt::Key_Return);
    ASSERT_EQ(w.current().shown().annotations.size(), 1U);
    EXPECT_EQ(w.current().shown().annotations[0].text, "Engstelle 狭窄 😀");
    EXPECT_EQ(w.current().shown().annotations[0].pixels.size(), 2U);
    EXPECT_TRUE(isDrawn("Engstelle"));

    w.press(Qt::Key_T, Qt::ShiftModifier);
    QTest::qWait(QApplication::doubleClickInterval() + 20);
    click(at({300, 300}));
    auto* words = view().findChild<QLineEdit*>();
    ASSERT_TRUE(words);
    QTest::keyClick(words, Qt::Key_Return);
    EXPECT_EQ(w.current().shown().annotations.size(), 1U) << "no words, no text";
    w.history().undo();
    EXPECT_TRUE(w.current().shown().annotations.empty());
}

TEST_F(WindowMarks, PicturesTablesAndTheCaseHaveThem)
{
    const test::TemporaryFolder folder;
    const auto exported = [&](const char* name, ui::ImageFileFormat format = ui::ImageFileFormat::Png) {
        const std::string path = folder.file(name);
        ui::OverlayExportOptions choice{1024, ui::Toggle::Off, ui::Toggle::Off};
        choice.format = format;
        w.controller.exportController().exportOverlay(choice, QString::fromStdString(path));
        EXPECT_TRUE(test::waitFor([&path] { return !test::readText(path).empty(); }));
        return path;
    };
    const QImage plain(QString::fromStdString(exported("plain.png")));
    setPoint();
    w.press(Qt::Key_Escape);
    EXPECT_NE(plain, QImage(QString::fromStdString(exported("marked.png"))));
    EXPECT_NE(test::readText(exported("marked.svg", ui::ImageFileFormat::Svg)).find("Target point 1"),
              std::string::npos);
    EXPECT_EQ(test::readText(exported("marked.pdf", ui::ImageFileFormat::Pdf)).rfind("%PDF", 0), 0U);

    w.window.actions()[ui::Command::ExportTargetPoints]->trigger();
    w.saveAs(QString::fromStdString(folder.file("c.csv")));
    ASSERT_TRUE(test::waitFor([&] { return !test::readText(folder.file("c.csv")).empty(); }));
    EXPECT_NE(test::readText(folder.file("c.csv")).find("Target point 1"), std::string::npos);

    const auto saved = marks();
    w.controller.saveController().saveTo(QString::fromStdString(folder.file("marked.angiopose")));
    ASSERT_TRUE(test::waitFor([&] { return !w.controller.document().isModified(); }));
    w.controller.document().replace({}, {});
    EXPECT_TRUE(view().placedMarks().empty());
    w.drop({QString::fromStdString(folder.file("marked.angiopose"))});
    EXPECT_EQ(marks(), saved);
}

TEST_F(WindowMarks, ATypedScaleMeasures)
{
    w.press(Qt::Key_D, Qt::ShiftModifier);
    auto* plane = w.window.measure().findChild<QComboBox*>();
    plane->setFocus();
    QTest::keyClick(plane, Qt::Key_End);
    auto* scale = w.window.measure().findChild<QDoubleSpinBox*>();
    ASSERT_TRUE(scale->isVisibleTo(&w.window.measure()));
    scale->setFocus();
    scale->selectAll();
    QTest::keyClicks(scale, QStringLiteral("0.25"));
    QTest::keyClick(scale, Qt::Key_Return);
    EXPECT_EQ(w.current().shown().enteredMmPerPx, 0.25);
    dragFrom(at({100, 200}), at({300, 200}));
    ASSERT_EQ(w.current().shown().measurements.size(), 1U);
    EXPECT_EQ(w.current().shown().measurements[0].plane, core::MeasurementPlane::Typed);
    w.history().undo();
    w.history().undo();
    EXPECT_FALSE(w.current().shown().enteredMmPerPx);
}

}   // namespace
}   // namespace angiopose::app
