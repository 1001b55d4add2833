#pragma once

#include "ui/slices/slice_view.h"

#include <QWidget>

#include <map>

class QHBoxLayout;

namespace ui {

/// The three planes of the scan in place of the angiogram, with window presets above and room for a panel beside.
class SlicesPage : public QWidget {
    Q_OBJECT
public:
    explicit SlicesPage(SliceModel& model, QWidget* parent = nullptr);

    SliceView& view(core::BodyPlane plane) { return *views_.at(plane); }
    void setSidePanel(QWidget* panel);

signals:
    void closeRequested();
    void windowRequested();   ///< a window of its own, or back

private:
    QWidget* makeBar();
    void fillPresets(QHBoxLayout& bar);

    SliceModel& model_;
    std::map<core::BodyPlane, SliceView*> views_;
    QHBoxLayout* columns_;
};

}   // namespace ui
