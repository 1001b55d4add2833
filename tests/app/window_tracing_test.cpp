#include "core/messages/messages.h"
#include "core/tracing/volume/tracing_warnings.h"
#include "tests/app/scan_window.h"
#include "tests/support/temporary_folder.h"

#include <QCheckBox>
#include <QListWidget>
#include <QSlider>
#include <QToolButton>

#include <algorithm>

namespace angiopose::app {
namespace {

using core::BodyPlane;
using WindowTracing = test::ScanWindow;

TEST_F(WindowTracing, TraceWithThresholdAndSeedsAsOneStep)
{
    const auto before = w.current().vessels.tree;
    const core::VesselTracingOptions beforeOptions = w.current().vessels.input.tracing;
    press<QCheckBox>(QStringLiteral("Automatic threshold"));
    auto* slider = w.window.tracing().findChild<QSlider*>();
    ASSERT_TRUE(slider->isEnabled());
    slider->setValue(180);
    EXPECT_EQ(model().previewFrom(), 180.0);
    press<QPushButton>(QStringLiteral("Seeds"));
    model().setCrosshair({0, 0, 20});
    QApplication::processEvents();
    click(BodyPlane::Axial, {0, 0, 20});
    EXPECT_EQ(w.window.tracing().findChild<QListWidget*>()->count(), 1);
    EXPECT_TRUE(w.current().vessels.input.tracing == beforeOptions);   // the options are a draft until the trace

    press<QPushButton>(QStringLiteral("Trace"));
    ASSERT_TRUE(waitForTrace());

    EXPECT_NE(w.current().vessels.tree, before);
    EXPECT_EQ(test::endsOf(*w.current().vessels.tree), 3);
    EXPECT_EQ(w.current().vessels.input.tracing.threshold, 180.0);
    ASSERT_EQ(w.current().vessels.input.tracing.seedsInPatient.size(), 1U);
    EXPECT_EQ(w.history().undoText(), QStringLiteral("Trace vessels"));
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().vessels.tree, before);
    EXPECT_FALSE(w.current().vessels.input.tracing.threshold);
    EXPECT_EQ(w.window.tracing().findChild<QListWidget*>()->count(), 0);
}

TEST_F(WindowTracing, ShowsTheFalseLumenOfADissectionOnACardThatPlacesItsSeeds)
{
    const auto button = [this](const char* words) {
        for (auto* each : w.window.tracing().findChildren<QPushButton*>()) {
            if (each->text() == QLatin1String(words)) {
                return each;
            }
        }
        return static_cast<QPushButton*>(nullptr);
    };
    ASSERT_TRUE(button("Show") && button("Add seed"));
    EXPECT_FALSE(button("Show")->isVisibleTo(&w.window.tracing()));
    w.controller.tracing().setWarnings(
        {core::messages::possiblyNotHounsfield(),
         core::adjacentLumenWarning(core::AdjacentLumen{.adjacentMm = 120.0, .positionInPatient = {3.0, 4.0, 25.0}})});
    EXPECT_TRUE(button("Show")->isVisibleTo(&w.window.tracing()));
    QTest::mouseClick(button("Show"), Qt::LeftButton);
    EXPECT_LT((model().crosshair() - Eigen::Vector3d(3.0, 4.0, 25.0)).norm(), 1.0);
    QTest::mouseClick(button("Add seed"), Qt::LeftButton);
    const auto& seeds = w.controller.tracing().draft().seedsInPatient;
    ASSERT_EQ(seeds.size(), 2u) << "one in each lumen";
    EXPECT_EQ(seeds.back(), Eigen::Vector3d(3.0, 4.0, 25.0));
    EXPECT_FALSE(button("Show")->isVisibleTo(&w.window.tracing()));
    w.controller.tracing().setWarnings({core::messages::possiblyNotHounsfield()});
    EXPECT_FALSE(button("Show")->isVisibleTo(&w.window.tracing()));
}

TEST_F(WindowTracing, RemoveSeedsFromTheList)
{
    press<QPushButton>(QStringLiteral("Seeds"));
    click(BodyPlane::Axial, model().crosshair());
    press<QPushButton>(QStringLiteral("Avoid"));
    click(BodyPlane::Coronal, model().crosshair() + Eigen::Vector3d(12, 0, 0));
    auto* list = w.window.tracing().findChild<QListWidget*>();
    ASSERT_EQ(list->count(), 2);
    EXPECT_EQ(model().points().at(ui::SliceMarkKind::Avoid).size(), 1U);

    list->setFocus();
    list->setCurrentRow(0);
    const auto tree = w.current().vessels.tree;
    QTest::keyClick(list, Qt::Key_Delete);
    EXPECT_EQ(list->count(), 1);
    EXPECT_EQ(w.current().vessels.tree, tree);   // the key acted on the list, not on the branches
    EXPECT_TRUE(model().points().at(ui::SliceMarkKind::Seed).empty());
}

TEST_F(WindowTracing, StoppingKeepsTheTree)
{
    const auto before = w.current().vessels.tree;
    const int steps = w.history().count();
    press<QPushButton>(QStringLiteral("Trace"));
    EXPECT_TRUE(w.controller.tracing().isRunning());
    press<QPushButton>(QStringLiteral("Stop"));
    ASSERT_TRUE(waitForTrace());
    EXPECT_EQ(w.current().vessels.tree, before);
    EXPECT_EQ(w.history().count(), steps);
}

TEST_F(WindowTracing, TellWhyNothingCanBeTraced)
{
    press<QCheckBox>(QStringLiteral("Automatic threshold"));
    w.window.tracing().findChild<QSlider*>()->setValue(1100);
    const auto before = w.current().vessels.tree;
    press<QPushButton>(QStringLiteral("Trace"));
    ASSERT_TRUE(waitForTrace());
    EXPECT_EQ(w.current().vessels.tree, before);
    EXPECT_FALSE(w.window.findChildren<ui::MessageDialog*>().isEmpty());
}

TEST_F(WindowTracing, ShowLabelsOfTheSameScan)
{
    const auto scan = w.current().vessels.scan;
    const QString labels = folder.filePath(QStringLiteral("labels.nii.gz"));
    core::LabelVolume image = test::forkLabels();
    std::ranges::replace(image.voxels, std::uint16_t{7}, std::uint16_t{0});
    ASSERT_TRUE(io::writeLabels(image, labels.toStdString()));
    w.drop({labels});
    EXPECT_EQ(w.current().vessels.input.kind, core::VesselInputKind::Segmentation);
    EXPECT_EQ(w.current().vessels.scan, scan);
    EXPECT_EQ(w.current().vessels.scanFile.path, scanPath.toStdString());
    ASSERT_TRUE(model().lumen());
    EXPECT_NE(model().lumen()->at(32, 18, 26), 0);   // in the trunk
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().vessels.input.kind, core::VesselInputKind::Volume);
}

}   // namespace
}   // namespace angiopose::app
