#include "io/volume_file.h"
#include "tests/app/open_window.h"
#include "tests/support/forked_vessel.h"
#include "tests/support/temporary_folder.h"
#include "ui/slices/label_choice.h"
#include "ui/slices/slices_page.h"

#include <QTreeWidget>

namespace angiopose::app {
namespace {

constexpr int artery = 2;
constexpr int organ = 7;
constexpr int sideBranch = 9;

/// Fixture: the bifurcating vessel as an artery whose upper part has its own label, next to an organ, with names as
/// Slicer writes them.
class WindowLabels : public ::testing::Test {
protected:
    void SetUp() override
    {
        core::LabelVolume image = test::forkLabels();
        const auto upper = image.voxels.begin() + static_cast<std::ptrdiff_t>(image.geometry.index(0, 0, 60));
        std::replace(upper, image.voxels.end(), std::uint16_t{artery}, std::uint16_t{sideBranch});
        const auto low = image.voxels.begin() + static_cast<std::ptrdiff_t>(image.geometry.index(0, 0, 12));
        std::replace(low, image.voxels.end(), std::uint16_t{organ}, std::uint16_t{0});
        const std::string plain = files.file("plain.nrrd");
        ASSERT_TRUE(io::writeLabels(image, plain));
        std::string content = test::readText(plain);
        content.insert(content.find("\n\n") + 1,
                       "Segment0_ID:=a\nSegment0_LabelValue:=2\nSegment0_Name:=hepatic artery\n"
                       "Segment1_ID:=b\nSegment1_LabelValue:=7\nSegment1_Name:=liver\n");
        path = QString::fromStdString(files.write("organs.seg.nrrd", content));
        w.drop({path});
        ASSERT_TRUE(w.current().vessels.tree);
        ASSERT_TRUE(test::waitFor([this] { return list().topLevelItemCount() == 3; }));
    }

    ui::LabelChoice& choice() { return w.window.tracing().labels(); }
    QTreeWidget& list() { return *choice().findChild<QTreeWidget*>(); }
    void clickBoxOf(int row)
    {
        const QRect item = list().visualItemRect(list().topLevelItem(row));
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, QPoint(item.left() + 12, item.center().y()));
    }
    void pressButton(const QString& text)
    {
        for (QPushButton* button : w.window.tracing().findChildren<QPushButton*>()) {
            if (button->text() == text && button->isVisible()) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        FAIL() << "no button " << text.toStdString();
    }
    void trace()
    {
        pressButton(QStringLiteral("Trace"));
        ASSERT_TRUE(test::waitFor([this] { return !w.controller.tracing().isRunning(); }));
    }
    double highestPoint()
    {
        double highest = -1e9;
        for (const core::VesselBranch& branch : w.current().vessels.tree->branches) {
            for (const Eigen::Vector3d& point : branch.pointsInPatient) {
                highest = std::max(highest, point.z());
            }
        }
        return highest;
    }

    test::TemporaryFolder files;
    QString path;
    test::OpenWindow w;
};

TEST_F(WindowLabels, AreListedWithNamesAndVolumes)
{
    EXPECT_TRUE(w.window.actions()[ui::Command::SlicesLarge]->isChecked()) << "nothing else to look at yet";
    EXPECT_TRUE(list().isVisible());
    EXPECT_EQ(list().topLevelItem(0)->text(0), QStringLiteral("2  hepatic artery"));
    EXPECT_EQ(list().topLevelItem(2)->text(0), QStringLiteral("Label 9"));
    EXPECT_EQ(list().topLevelItem(1)->text(1), QStringLiteral("3.84 ml"));
    EXPECT_EQ(choice().chosenLabels(), std::set<int>{artery}) << "by its name";
    EXPECT_EQ(w.current().vessels.input.labels, std::vector<int>{artery});
}

TEST_F(WindowLabels, TickTraceAndUndoAsOneStep)
{
    const auto before = w.current().vessels.tree;
    EXPECT_LT(highestPoint(), 56.0);
    clickBoxOf(2);
    EXPECT_EQ(choice().chosenLabels(), (std::set<int>{artery, sideBranch}));
    EXPECT_EQ(w.current().vessels.input.labels, std::vector<int>{artery}) << "a draft until it has been traced";
    const int steps = w.history().count();
    trace();
    EXPECT_EQ(w.current().vessels.input.labels, (std::vector<int>{artery, sideBranch}));
    EXPECT_GT(highestPoint(), 75.0);
    EXPECT_EQ(w.history().count(), steps + 1);

    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().vessels.tree, before);
    EXPECT_EQ(choice().chosenLabels(), std::set<int>{artery});
    w.press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(choice().chosenLabels(), (std::set<int>{artery, sideBranch}));
}

TEST_F(WindowLabels, ChooseByKeysAlone)
{
    w.window.actions()[ui::Command::SlicesLarge]->setChecked(false);
    w.press(Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(list().hasFocus());
    QTest::keyClick(&list(), Qt::Key_Home);
    QTest::keyClick(&list(), Qt::Key_Down);
    const Eigen::Vector3d inOrgan = w.window.slices().crosshair();
    EXPECT_EQ(w.window.slices().labelNameAt(inOrgan), QStringLiteral("7  liver"));
    QTest::keyClick(&list(), Qt::Key_Space);
    EXPECT_EQ(choice().chosenLabels(), (std::set<int>{artery, organ}));
    QTest::keyClick(&list(), Qt::Key_Space);
    QTest::keyClick(&list(), Qt::Key_Up);
    QTest::keyClick(&list(), Qt::Key_Space);
    EXPECT_TRUE(choice().chosenLabels().empty());
    EXPECT_FALSE(w.window.actions()[ui::Command::TraceScan]->isEnabled()) << "nothing to trace";
    pressButton(QStringLiteral("Vessels"));
    EXPECT_EQ(choice().chosenLabels(), std::set<int>{artery});
    EXPECT_TRUE(w.window.actions()[ui::Command::TraceScan]->isEnabled());
}

TEST_F(WindowLabels, AllAreKeptAsAllThoughNamesSayOtherwise)
{
    pressButton(QStringLiteral("All"));
    trace();
    EXPECT_EQ(w.current().vessels.input.labels, (std::vector<int>{artery, organ, sideBranch}));
}

TEST_F(WindowLabels, SlicesShowThemInTheirColors)
{
    ui::SliceView& view = w.window.slicesPage().view(core::BodyPlane::Axial);
    const auto colorAt = [&](const Eigen::Vector3d& place) {
        w.window.slices().setCrosshair({25, -14, place.z()});
        QApplication::processEvents();
        const QPoint at = view.widgetFromPatient(place).toPoint();
        return QColor(view.grab().toImage().pixel(at * view.devicePixelRatio()));
    };
    const auto hueOf = [](std::size_t row) {
        const ui::Color color = ui::labelColor(row);
        return QColor(color.red, color.green, color.blue).hueF();
    };
    const Eigen::Vector3d inTrunk(2, 1, 20);
    const QColor ticked = colorAt(inTrunk);
    EXPECT_NEAR(ticked.hueF(), hueOf(0), 0.05);
    EXPECT_NEAR(colorAt({0, 19, 2}).hueF(), hueOf(1), 0.08) << "the organ";
    EXPECT_NEAR(colorAt({-16.5, 0, 73}).hueF(), hueOf(2), 0.08) << "a branch";
    clickBoxOf(0);
    EXPECT_LT(colorAt(inTrunk).value(), ticked.value() / 2) << "no longer ticked: faint";
}

TEST_F(WindowLabels, AreGoneWithTheLabelImage)
{
    w.drop({QString::fromStdString(files.write("tree.csv", "x,y,z,radius,branch\n0,0,0,2,1\n0,0,40,2,1\n"))});
    ASSERT_EQ(w.current().vessels.input.kind, core::VesselInputKind::Centerline);
    EXPECT_FALSE(choice().isVisible());
    EXPECT_FALSE(w.window.actions()[ui::Command::ChooseLabels]->isEnabled());
    EXPECT_TRUE(w.window.slices().labelTints().empty());
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(w.window.actions()[ui::Command::ChooseLabels]->isEnabled());
}

}   // namespace
}   // namespace angiopose::app
