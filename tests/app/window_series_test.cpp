#include "tests/app/open_window.h"
#include "tests/io/series/ct_phantom.h"
#include "tests/io/study/study_disc.h"
#include "tests/support/forked_vessel.h"

#include <QTreeWidget>

namespace angiopose::app {
namespace {

using test::OpenWindow;

/// Writes a CT angiogram of a bifurcating vessel, and the three slices of another series.
void writeStudy(const test::TemporaryFolder& folder)
{
    test::writeShuffled(folder, test::allSlices(test::forkScan()));
    for (int k = 0; k < 3; ++k) {
        test::CtSlice slice;
        slice.seriesUid = "1.2.9";
        slice.description = "native";
        slice.position = {0, 0, 5.0 * k};
        slice.sopInstanceUid = "1.2.9." + std::to_string(k);
        slice.pixels.assign(72, 0);
        folder.write("native" + std::to_string(k), test::ctSlice(slice));
    }
}

/// A folder dropped together with another file is not browsed: one of its series is opened with that file.
TEST(WindowSeries, AFolderWithSeveralBesideAFileAsksAndTheChosenOneIsTraced)
{
    const test::TemporaryFolder folder;
    writeStudy(folder);
    const test::TemporaryFolder beside;
    ASSERT_TRUE(io::writeAngiogram(test::spotRun(), beside.file("run.dcm")));
    OpenWindow w;

    w.drop({QString::fromStdString(folder.file("")), QString::fromStdString(beside.file("run.dcm"))});

    const QList<QDialog*> asked = w.dialogs("seriesChooser");
    ASSERT_EQ(asked.size(), 1);
    const auto* list = asked.front()->findChild<QTreeWidget*>();
    ASSERT_EQ(list->topLevelItemCount(), 2);
    EXPECT_EQ(list->topLevelItem(0)->text(0), QStringLiteral("CTA 0.75"));
    EXPECT_EQ(list->topLevelItem(0)->text(3), QStringLiteral("64 × 40 × 96"));
    EXPECT_FALSE(w.current().vessels.tree);
    OpenWindow::clickButton(asked.front(), QStringLiteral("Open"));
    ASSERT_TRUE(test::waitFor([&] { return !w.controller.isLoading(); }));

    ASSERT_TRUE(w.current().vessels.tree);
    EXPECT_EQ(test::endsOf(*w.current().vessels.tree), 3);
    EXPECT_EQ(w.current().vessels.input.kind, core::VesselInputKind::Volume);
    EXPECT_EQ(w.current().vessels.input.seriesId, "1.2.3");
    ASSERT_TRUE(w.current().vessels.scan);
    w.press(Qt::Key_Z, Qt::ControlModifier);
}

TEST(WindowSeries, CancellingTheChoiceLeavesTheCaseAsItWas)
{
    const test::TemporaryFolder folder;
    writeStudy(folder);
    const test::TemporaryFolder beside;
    ASSERT_TRUE(io::writeAngiogram(test::spotRun(), beside.file("run.dcm")));
    OpenWindow w;
    w.drop({QString::fromStdString(folder.file("")), QString::fromStdString(beside.file("run.dcm"))});
    ASSERT_EQ(w.dialogs("seriesChooser").size(), 1);

    OpenWindow::clickButton(w.dialogs("seriesChooser").front(), QStringLiteral("Cancel"));

    EXPECT_TRUE(w.dialogs("seriesChooser").isEmpty());
    EXPECT_FALSE(w.current().vessels.tree);
    EXPECT_FALSE(w.controller.isLoading());
}

}   // namespace
}   // namespace angiopose::app
