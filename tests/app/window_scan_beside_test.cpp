#include "io/case/case_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"
#include "tests/app/open_window.h"
#include "tests/support/for_each.h"
#include "tests/support/forked_vessel.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QLabel>
#include <QSlider>
#include <QTemporaryDir>

namespace angiopose::app {
namespace {

using test::OpenWindow;

/// Fixture: vessels from a file, and then the scan of the same vessels.
class WindowScanBeside : public ::testing::Test {
protected:
    void SetUp() override
    {
        const QString treePath = folder.filePath(QStringLiteral("tree.csv"));
        const QString scanPath = folder.filePath(QStringLiteral("scan.nrrd"));
        core::VesselTree tree;
        tree.branches.push_back({1, "", {{0, 0, 0}, {4, 4, 4}, {8, 8, 8}}, {1.0, 1.0, 1.0}, -1});
        const core::Volume scan = test::forkScan();
        for (Eigen::Vector3d& point : tree.branches.front().pointsInPatient) {
            point += scan.geometry.patientFromVoxel() * Eigen::Vector3d(10.0, 10.0, 10.0);
        }
        ASSERT_TRUE(io::writeVesselTree(tree, treePath.toStdString()));
        ASSERT_TRUE(io::writeVolume(scan, scanPath.toStdString()));
        w.drop({treePath});
        ASSERT_TRUE(w.current().vessels.tree);
        before = w.current().vessels.tree;
        w.drop({scanPath});
        ASSERT_EQ(w.dialogs("scanQuestion").size(), 1);
    }
    void answer(const QString& verb)
    {
        OpenWindow::clickButton(w.dialogs("scanQuestion").front(), verb);
        EXPECT_TRUE(test::waitFor([this] { return !w.controller.isLoading(); }));
        w.window.activateWindow();   // there is no window manager to do it
        EXPECT_TRUE(QTest::qWaitForWindowActive(&w.window));
    }

    QTemporaryDir folder;
    OpenWindow w;
    std::shared_ptr<const core::VesselTree> before;
};

TEST_F(WindowScanBeside, IsShownInSlicesWithTheVesselsThatAreThere)
{
    answer(QStringLiteral("Show with the vessels"));
    ASSERT_TRUE(w.current().vessels.scan);
    EXPECT_EQ(w.current().vessels.tree, before);
    EXPECT_TRUE(w.current().vessels.file.path.ends_with("tree.csv"));
    EXPECT_TRUE(w.current().vessels.scanFile.path.ends_with("scan.nrrd"));
    EXPECT_EQ(w.current().vessels.scanFile.sha256.size(), 64U);
    EXPECT_TRUE(w.window.slices().hasScan());
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(w.current().vessels.scan);
}

TEST_F(WindowScanBeside, OrItsVesselsAreTraced)
{
    answer(QStringLiteral("Trace this scan"));
    ASSERT_TRUE(w.current().vessels.scan);
    EXPECT_NE(w.current().vessels.tree, before);
    EXPECT_TRUE(w.current().vessels.file.path.ends_with("scan.nrrd"));
}

/// The bifurcating vessel with a lumen hardly brighter than tissue: no threshold can be derived from the values.
core::Volume faintScan()
{
    core::Volume scan = test::forkScan();
    test::forEachVoxel(scan.geometry.size, [&](int i, int j, int k) {
        const std::int16_t value = scan.at(i, j, k);
        scan.at(i, j, k) = value > 60 ? static_cast<std::int16_t>(60 + (value - 60) / 10) : value;
    });
    return scan;
}

TEST(WindowScanWithoutVessels, IsShownAndTracedByHand)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("faint.nrrd"));
    ASSERT_TRUE(io::writeVolume(faintScan(), path.toStdString()));
    OpenWindow w;
    w.drop({path});
    ASSERT_TRUE(w.current().vessels.scan);
    EXPECT_FALSE(w.current().vessels.tree);
    EXPECT_TRUE(w.window.slices().hasScan());

    EXPECT_TRUE(w.window.actions()[ui::Command::SlicesLarge]->isChecked());
    EXPECT_TRUE(w.window.tracing().isVisible());
    w.window.tracing().findChild<QCheckBox*>()->setChecked(false);
    auto* threshold = w.window.tracing().findChild<QSlider*>();
    ASSERT_TRUE(threshold->isVisible());
    threshold->setValue(70);
    w.window.actions()[ui::Command::TraceScan]->trigger();
    ASSERT_TRUE(test::waitFor([&] { return w.current().vessels.tree != nullptr; }));
    EXPECT_EQ(test::endsOf(*w.current().vessels.tree), 3);
    EXPECT_EQ(w.current().vessels.input.kind, core::VesselInputKind::Volume);
    EXPECT_TRUE(w.current().vessels.file.path.ends_with("faint.nrrd"));
    EXPECT_TRUE(w.current().vessels.scanFile.path.empty());

    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(w.current().vessels.tree);
    EXPECT_TRUE(w.current().vessels.scanFile.path.ends_with("faint.nrrd"));
}

/// The case file cannot hold a scan without vessels; the message appears before the file dialog.
TEST(WindowScanWithoutVessels, CannotBeSavedAndSaysWhy)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("faint.nrrd"));
    ASSERT_TRUE(io::writeVolume(faintScan(), path.toStdString()));
    OpenWindow w;
    w.drop({path});
    ASSERT_TRUE(w.current().vessels.scan);
    w.window.actions()[ui::Command::Save]->trigger();
    EXPECT_TRUE(w.window.findChildren<QFileDialog*>().isEmpty());
    const QList<QDialog*> messages = w.dialogs("messageDialog");
    ASSERT_EQ(messages.size(), 1);
    QString said;
    for (const QLabel* label : messages.front()->findChildren<QLabel*>()) {
        said += label->text();
    }
    EXPECT_TRUE(said.contains(QStringLiteral("scan alone"))) << said.toStdString();
    EXPECT_FALSE(io::saveCase(w.current(), folder.filePath(QStringLiteral("x.angiopose")).toStdString()));
}

TEST(WindowScanWithoutVessels, LeavesOtherVesselsAlone)
{
    const QTemporaryDir folder;
    const QString good = folder.filePath(QStringLiteral("good.nrrd"));
    const QString faint = folder.filePath(QStringLiteral("faint.nrrd"));
    ASSERT_TRUE(io::writeVolume(test::forkScan(), good.toStdString()));
    ASSERT_TRUE(io::writeVolume(faintScan(), faint.toStdString()));
    OpenWindow w;
    w.drop({good});
    const auto before = w.current().vessels.tree;
    ASSERT_TRUE(before);
    w.drop({faint});
    EXPECT_EQ(w.current().vessels.tree, before);
    EXPECT_TRUE(w.current().vessels.file.path.ends_with("good.nrrd"));
}

}   // namespace
}   // namespace angiopose::app
