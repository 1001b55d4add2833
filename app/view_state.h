#pragma once

#include "core/imaging/display_range.h"
#include "ui/scenes/view_rect.h"
#include "ui/slices/slice_picture.h"

#include <Eigen/Core>

#include <optional>
#include <set>

namespace ui {
class MainWindow;
}

namespace app {

class CaseController;

/// What of the open case is seen at the moment, and belongs neither to it nor to the layout of the window.
struct ViewState {
    std::optional<ui::ViewRect> part;   ///< of the angiogram; not set: all of it
    std::optional<core::DisplayRange> range;   ///< not set while there is none
    std::set<int> selectedBranches;
    Eigen::Vector3d crosshairInPatient = Eigen::Vector3d::Zero();
    ui::GreyWindow sliceWindow;
    bool areSlicesLarge = false;
};

ViewState viewStateOf(ui::MainWindow& window, CaseController& controller);
void showAgain(const ViewState& state, ui::MainWindow& window, CaseController& controller);

}   // namespace app
