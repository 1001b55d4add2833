#include "tests/app/open_window.h"
#include "tests/io/series/dicom_slices.h"
#include "tests/support/forked_vessel.h"

#include <QTemporaryDir>
#include <QTreeWidget>

namespace app {
namespace {

using test::OpenWindow;

void writeSlice(const QTemporaryDir& folder, const test::CtSlice& slice)
{
    QFile file(folder.filePath(QString::fromStdString(slice.sopInstanceUid)));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(test::ctSlice(slice)));
}

/// A CT angiogram of a forked vessel, and the three slices of another series.
void writeStudy(const QTemporaryDir& folder)
{
    const core::Volume scan = test::forkScan();
    const core::VolumeGeometry& geometry = scan.geometry;
    for (int k = 0; k < geometry.size.z(); ++k) {
        test::CtSlice slice;
        slice.columns = geometry.size.x();
        slice.rows = geometry.size.y();
        slice.columnSpacingMm = slice.rowSpacingMm = 1.0;
        slice.intercept = 0.0;
        slice.position = {geometry.originInPatient.x(), geometry.originInPatient.y(), geometry.originInPatient.z() + k};
        slice.sopInstanceUid = "1.2.3." + std::to_string(k);
        const auto first = scan.voxels.begin() + static_cast<std::ptrdiff_t>(geometry.index(0, 0, k));
        slice.pixels.assign(first, first + static_cast<std::ptrdiff_t>(slice.columns) * slice.rows);
        writeSlice(folder, slice);
    }
    for (int k = 0; k < 3; ++k) {
        test::CtSlice slice;
        slice.seriesUid = "1.2.9";
        slice.description = "native";
        slice.position = {0, 0, 5.0 * k};
        slice.sopInstanceUid = "1.2.9." + std::to_string(k);
        slice.pixels.assign(72, 0);
        writeSlice(folder, slice);
    }
}

TEST(WindowSeries, AFolderWithSeveralAsksAndTheChosenOneIsTraced)
{
    const QTemporaryDir folder;
    writeStudy(folder);
    OpenWindow w;

    w.drop({folder.path()});

    const QList<QDialog*> asked = w.dialogs("seriesChooser");
    ASSERT_EQ(asked.size(), 1);
    const auto* list = asked.front()->findChild<QTreeWidget*>();
    ASSERT_EQ(list->topLevelItemCount(), 2);
    EXPECT_EQ(list->topLevelItem(0)->text(0), QStringLiteral("CTA 0.75"));
    EXPECT_EQ(list->topLevelItem(0)->text(3), QStringLiteral("64 × 40 × 96"));
    EXPECT_FALSE(w.current().tree);
    OpenWindow::clickButton(asked.front(), QStringLiteral("Open"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !w.controller.isLoading(); }, test::patienceMs));

    ASSERT_TRUE(w.current().tree);
    EXPECT_EQ(test::endsOf(*w.current().tree), 3);
    EXPECT_EQ(w.current().vesselInput.kind, core::VesselInputKind::Volume);
    EXPECT_EQ(w.current().vesselInput.seriesId, "1.2.3");
    ASSERT_TRUE(w.current().volume);
    w.press(Qt::Key_Z, Qt::ControlModifier);
}

TEST(WindowSeries, CancellingTheChoiceLeavesTheCaseAsItWas)
{
    const QTemporaryDir folder;
    writeStudy(folder);
    OpenWindow w;
    w.drop({folder.path()});
    ASSERT_EQ(w.dialogs("seriesChooser").size(), 1);

    OpenWindow::clickButton(w.dialogs("seriesChooser").front(), QStringLiteral("Cancel"));

    EXPECT_TRUE(w.dialogs("seriesChooser").isEmpty());
    EXPECT_FALSE(w.current().tree);
    EXPECT_FALSE(w.controller.isLoading());
}

}   // namespace
}   // namespace app
