#include "app/document/case_document.h"
#include "io/case/case_file.h"
#include "tests/app/scan_window.h"
#include "ui/slices/slice_tool.h"

#include <QColor>
#include <QImage>
#include <QPushButton>

namespace angiopose::app {
namespace {

using core::BodyPlane;

/// Fixture: a scan of a bifurcating vessel whose side branch was removed from the tree, as if tracing had missed it.
class WindowPath : public test::ScanWindow {
protected:
    void SetUp() override
    {
        ScanWindow::SetUp();
        const auto& branches = w.current().vessels.tree->branches;
        ASSERT_GE(branches.size(), 2U);
        missed = branches.back();
        w.controller.branches().select({missed.id});
        w.window.actions()[ui::Command::DeleteBranches]->trigger();
        ASSERT_FALSE(w.current().vessels.tree->find(missed.id));
        count = w.current().vessels.tree->branches.size();
    }
    void clickAt(const Eigen::Vector3d& point)
    {
        model().setCrosshair(point);   // shows the slice that contains the point
        QApplication::processEvents();
        click(BodyPlane::Axial, point);
    }
    bool waitForBranch()
    {
        return test::waitFor([this] { return w.current().vessels.tree->branches.size() > count; });
    }

    core::VesselBranch missed;
    std::size_t count = 0;
};

TEST_F(WindowPath, TwoClicksAddAMissedVesselAsOneStep)
{
    const QString noteBefore = w.history().undoText();
    w.press(Qt::Key_I, Qt::ControlModifier);
    ASSERT_TRUE(model().tool());
    EXPECT_TRUE(model().tool()->caption().contains(QStringLiteral("click its start")));
    clickAt(missed.pointsInPatient.front());
    EXPECT_TRUE(model().tool()->caption().contains(QStringLiteral("click its end")));
    clickAt(missed.pointsInPatient.back());
    ASSERT_TRUE(waitForBranch());

    const core::VesselBranch& added = w.current().vessels.tree->branches.back();
    double farthestMm = 0.0;
    for (const Eigen::Vector3d& point : added.pointsInPatient) {
        double nearestMm = 1e9;
        for (const Eigen::Vector3d& other : missed.pointsInPatient) {
            nearestMm = std::min(nearestMm, (point - other).norm());
        }
        farthestMm = std::max(farthestMm, nearestMm);
    }
    EXPECT_LT(farthestMm, 2.0);
    EXPECT_NEAR(added.lengthMm(), missed.lengthMm(), 4.0);
    EXPECT_EQ(w.history().undoText(), QStringLiteral("Trace one vessel"));
    ASSERT_TRUE(model().tool()) << "the mode stays for the next vessel";
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().vessels.tree->branches.size(), count);
    EXPECT_EQ(w.history().undoText(), noteBefore);
}

TEST_F(WindowPath, EscapeTakesTheFirstClickBackThenEndsTheMode)
{
    press<QPushButton>(QStringLiteral("Trace between two points"));
    ASSERT_TRUE(model().tool());
    clickAt(missed.pointsInPatient.front());
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Escape);
    ASSERT_TRUE(model().tool());
    EXPECT_TRUE(model().tool()->caption().contains(QStringLiteral("click its start")));
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Escape);
    EXPECT_FALSE(model().tool());
    EXPECT_FALSE(w.window.actions()[ui::Command::TraceBetween]->isChecked());
}

TEST_F(WindowPath, AddedVesselIsKeptWithTheCase)
{
    w.press(Qt::Key_I, Qt::ControlModifier);
    clickAt(missed.pointsInPatient.front());
    clickAt(missed.pointsInPatient.back());
    ASSERT_TRUE(waitForBranch());
    const QString imagePath = folder.filePath(QStringLiteral("frame.png"));   // a case can be saved only with an image
    QImage image(128, 128, QImage::Format_Grayscale8);
    for (int x = 0; x < image.width(); ++x) {
        for (int y = 0; y < image.height(); ++y) {
            const int gray = std::abs(x - y) < 3 ? 40 : 120 + x / 2;
            image.setPixelColor(x, y, QColor::fromRgb(qRgb(gray, gray, gray)));
        }
    }
    ASSERT_TRUE(image.save(imagePath));
    w.drop({imagePath});
    ASSERT_EQ(w.current().vessels.tree->branches.size(), count + 1);
    const std::string path = folder.filePath(QStringLiteral("case.angiopose")).toStdString();
    const auto saved = io::saveCase(w.current(), path);
    ASSERT_TRUE(saved) << saved.error().message.text();
    const auto added = w.current().vessels.tree->branches.back();
    test::OpenWindow other;
    other.drop({QString::fromStdString(path)});
    const auto& reopened = other.current().vessels;
    ASSERT_TRUE(reopened.tree);
    EXPECT_EQ(reopened.tree->branches.size(), count + 1);
    EXPECT_LT((reopened.tree->branches.back().pointsInPatient.back() - added.pointsInPatient.back()).norm(), 1e-3);
    EXPECT_TRUE(reopened.scan);
}

}   // namespace
}   // namespace angiopose::app
