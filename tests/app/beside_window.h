#pragma once

#include "tests/app/open_window.h"
#include "tests/support/simulated_views.h"

#include "ui/places/side_by_side.h"

#include <QCheckBox>

namespace angiopose::test {

/// A simulated tree in several views of known geometry, named "first", "second", …
inline core::Case simulatedViews(std::size_t count = 2)
{
    core::Case values = test::twoViewCase();
    while (values.views.size() < count) {
        values.views.push_back(values.views.back());
        values.views.back().cameraFromPatient.translation.x() += 5.0;
    }
    const std::array names{"first", "second", "third", "fourth"};
    for (std::size_t i = 0; i < values.views.size(); ++i) {
        values.views[i].name = names[i];
    }
    return values;
}

/// A window that shows the views of a case side by side.
struct BesideWindow : OpenWindow {
    explicit BesideWindow(const core::Case& shown = simulatedViews())
    {
        controller.document().replace(shown, {});
        press(Qt::Key_6);
        QApplication::processEvents();
    }
    ui::SideBySide& images() { return window.sideBySide(); }
    ui::AngiogramView& image() { return window.angiogramView(); }
    ui::AngiogramView& other(std::size_t index = 0) { return images().pane(index).image(); }
    core::RigidTransform poseOf(std::size_t view) { return current().views[view].cameraFromPatient; }
    void setTogether(bool together)
    {
        auto* box = window.registration().findChild<QCheckBox*>();
        ASSERT_TRUE(box->isVisible());
        if (box->isChecked() != together) {
            QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
        }
    }
    /// Presses in the middle of the shown image, drags by `by` px and keeps the button down. Returns the position of
    /// the pointer.
    QPoint drag(const QPoint& by)
    {
        const QPoint from = image().rect().center() + QPoint(3, 4);
        press(Qt::Key_N);
        QTest::mousePress(&image(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&image(), from + by / 2);
        QTest::mouseMove(&image(), from + by);
        return from + by;
    }
    void pointAt(ui::AngiogramView& view, const QPoint& at)
    {
        QTest::mouseMove(&view, at + QPoint(3, 3));
        QTest::mouseMove(&view, at);
    }
};

}   // namespace angiopose::test
