#pragma once

#include "io/volume_file.h"
#include "tests/app/open_window.h"
#include "tests/support/forked_vessel.h"
#include "ui/slices/slices_page.h"

#include <QTemporaryDir>
#include <QWheelEvent>

namespace angiopose::test {

using core::BodyPlane;

/// Fixture: a window with the traced scan of a bifurcating vessel.
class ScanWindow : public ::testing::Test {
protected:
    void SetUp() override
    {
        scanPath = folder.filePath(QStringLiteral("scan.nrrd"));
        ASSERT_TRUE(io::writeVolume(test::forkScan(), scanPath.toStdString()));
        w.drop({scanPath});
        ASSERT_TRUE(w.current().vessels.scan);
        QApplication::processEvents();
    }

    ui::SliceModel& model() { return w.window.slices(); }
    ui::SliceView& view(BodyPlane plane) { return w.window.slicesPage().view(plane); }
    QPoint placeOf(BodyPlane plane, const Eigen::Vector3d& point)
    {
        return view(plane).widgetFromPatient(point).toPoint();
    }
    void click(BodyPlane plane, const Eigen::Vector3d& point)
    {
        QTest::mouseClick(&view(plane), Qt::LeftButton, Qt::NoModifier, placeOf(plane, point));
    }
    void wheel(BodyPlane plane, int steps, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        const QPointF at = view(plane).rect().center();
        QWheelEvent event(at, view(plane).mapToGlobal(at), {}, {0, 120 * steps}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view(plane), &event);
    }
    void drag(BodyPlane plane, Qt::MouseButton button, const QPoint& by)
    {
        const QPoint from = view(plane).rect().center();
        QTest::mousePress(&view(plane), button, Qt::NoModifier, from);
        QTest::mouseMove(&view(plane), from + by / 2);
        QTest::mouseMove(&view(plane), from + by);
        QTest::mouseRelease(&view(plane), button, Qt::NoModifier, from + by);
    }
    template <class Button>
    void press(const QString& text)
    {
        for (Button* button : w.window.tracing().findChildren<Button*>()) {
            if (button->text() == text) {
                QTest::mouseClick(button, Qt::LeftButton, {}, {10, button->height() / 2});
                return;
            }
        }
        FAIL() << "no button " << text.toStdString();
    }
    bool waitForTrace()
    {
        return test::waitFor([this] { return !w.controller.tracing().isRunning(); });
    }

    QTemporaryDir folder;
    QString scanPath;
    OpenWindow w;
};

}   // namespace angiopose::test
