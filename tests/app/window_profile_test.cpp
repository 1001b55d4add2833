#include "core/measuring/branch_profile.h"
#include "tests/app/open_window.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"
#include "ui/plots/profile_plot.h"
#include "ui/slices/slice_model.h"
#include "ui/words/number.h"

#include <QLabel>

namespace angiopose::app {
namespace {

class WindowProfile : public ::testing::Test {
protected:
    void SetUp() override
    {
        w.openSample();
        w.window.profile().setFolded(false);
    }
    bool says(const QString& words)
    {
        const auto labels = w.window.profile().findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) {
            return label->isVisibleTo(&w.window.profile()) && label->text().contains(words);
        });
    }
    const core::VesselBranch& longest()
    {
        return *std::ranges::max_element(w.current().vessels.tree->branches, {}, &core::VesselBranch::lengthMm);
    }

    test::OpenWindow w;
};

TEST_F(WindowProfile, MeasuresTheBranchThatIsChosen)
{
    EXPECT_TRUE(w.window.profile().plot().isHidden());
    EXPECT_TRUE(says(QStringLiteral("Select a branch")));
    const core::VesselBranch& branch = longest();
    w.controller.branches().select({branch.id});
    EXPECT_FALSE(w.window.profile().plot().isHidden());
    const auto profile = core::measureProfile(branch);
    ASSERT_TRUE(profile);
    EXPECT_TRUE(says(ui::numberText(profile.value().lengthMm, 1) + QStringLiteral(" mm")));
    ASSERT_TRUE(profile.value().meanDiameterMm) << "the sample's tree has radii";
    EXPECT_TRUE(says(ui::numberText(*profile.value().meanDiameterMm, 2) + QStringLiteral(" mm")));

    w.controller.branches().select({branch.id, w.current().vessels.tree->branches.front().id, branch.id + 1});
    EXPECT_TRUE(w.window.profile().plot().isHidden()) << "two branches have no profile";
}

TEST_F(WindowProfile, APlaceOnTheProfileIsMarkedInImageAndSlices)
{
    const core::VesselBranch& branch = longest();
    w.controller.branches().select({branch.id});
    ui::ProfilePlot& plot = w.window.profile().plot();
    QTest::qWait(50);
    QTest::mouseClick(&plot, Qt::LeftButton, Qt::NoModifier, QPoint(plot.width() / 2, plot.height() / 2));
    const auto marked = w.window.angiogramView().crosshair().pointInPatient;
    ASSERT_TRUE(marked);
    const auto samples = core::measureProfile(branch).value().samples;
    EXPECT_LT((*marked - samples[samples.size() / 2].pointInPatient).norm(), 2.0);
    plot.setFocus();
    QTest::keyClick(&plot, Qt::Key_Right);
    const auto next = w.window.angiogramView().crosshair().pointInPatient;
    ASSERT_TRUE(next);
    EXPECT_NEAR((*next - *marked).norm(), 0.5, 0.05);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&plot, &leave);
    EXPECT_FALSE(w.window.angiogramView().crosshair().pointInPatient);
}

TEST_F(WindowProfile, ABranchWithoutRadiiSaysSo)
{
    core::Case session = w.current();
    core::VesselTree bare = *session.vessels.tree;
    for (core::VesselBranch& branch : bare.branches) {
        branch.radiusMm.clear();
    }
    session.vessels.tree = std::make_shared<const core::VesselTree>(bare);
    w.controller.document().replace(session, {});
    w.controller.branches().select({longest().id});
    EXPECT_TRUE(says(QStringLiteral("no radii")));
    EXPECT_FALSE(w.window.profile().plot().isHidden()) << "its bends are known";
}

TEST_F(WindowProfile, TablesAreWritten)
{
    const test::TemporaryFolder folder;
    w.window.actions()[ui::Command::ExportBranches]->trigger();
    w.saveAs(QString::fromStdString(folder.file("branches.csv")));
    const auto lines = [&] {
        const std::string text = test::readText(folder.file("branches.csv"));
        return static_cast<std::size_t>(std::ranges::count(text, '\n'));
    };
    EXPECT_TRUE(test::waitFor([&] { return lines() == w.current().vessels.tree->branches.size() + 1; }));
}

}   // namespace
}   // namespace angiopose::app
