#pragma once

#include "ui/slices/slice_view.h"

#include <QWidget>

#include <map>

class QBoxLayout;
class QScrollArea;

namespace angiopose::ui {

class WindowBar;

/// Page that replaces the angiogram with the three planes of the scan, with window presets above and a panel at the
/// side or, if the page is narrow, below.
class SlicesPage : public QWidget {
    Q_OBJECT
public:
    explicit SlicesPage(SliceModel& model, QWidget* parent = nullptr);

    SliceView& view(core::BodyPlane plane) { return *views_.at(plane); }
    const WindowBar& bar() const { return *bar_; }
    void setSidePanel(QWidget* panel);
    QSize minimumSizeHint() const override { return {240, 200}; }

signals:
    void closeRequested();
    void popOutRequested();   ///< requests popping out the page, or docking it

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    void placePanel();

    WindowBar* bar_;
    std::map<core::BodyPlane, SliceView*> views_;
    QBoxLayout* parts_;   ///< layout of slices and panel
    QWidget* panel_ = nullptr;
    QScrollArea* panelArea_ = nullptr;
};

}   // namespace angiopose::ui
