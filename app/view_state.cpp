#include "app/view_state.h"

#include "app/case_controller.h"
#include "ui/main_window.h"
#include "ui/views/angiogram_view.h"

namespace app {

ViewState viewStateOf(ui::MainWindow& window, CaseController& controller)
{
    ui::AngiogramView& view = window.angiogramView();
    ViewState state;
    if (controller.document().current().angiogram) {
        state.range = view.shownRange();
        if (!view.isFitted()) {
            state.part = view.visiblePart();
        }
    }
    state.selectedBranches = controller.branches().marks().selected;
    state.crosshairInPatient = window.slices().crosshair();
    state.sliceWindow = window.slices().window();
    state.areSlicesLarge = window.actions()[ui::Command::SlicesLarge]->isChecked();
    return state;
}

void showAgain(const ViewState& state, ui::MainWindow& window, CaseController& controller)
{
    if (state.part) {
        window.angiogramView().showPart(*state.part);
    }
    if (state.range) {
        window.angiogramView().setWindowLevel(state.range->window(), state.range->level());
    }
    controller.branches().select(state.selectedBranches);
    if (window.slices().hasScan()) {
        window.slices().setCrosshair(state.crosshairInPatient);
        window.slices().setWindow(state.sliceWindow);
    }
    window.actions()[ui::Command::SlicesLarge]->setChecked(state.areSlicesLarge);
}

}   // namespace app
