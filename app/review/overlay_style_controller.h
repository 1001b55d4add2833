#pragma once

#include "app/document/case_document.h"
#include "app/review/window_level_memory.h"
#include "app/showing/view_sync.h"
#include "core/imaging/display_range.h"
#include "core/registration/registration.h"

#include <QObject>

#include <vector>

namespace angiopose::ui {
class AngiogramPanel;
class AngiogramView;
class BottomStrip;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Controls the appearance of the overlay on the angiogram (style, opacity, depth cueing, swipe and lens, window/level)
/// and navigates to the worst branch. Does not change the case.
class OverlayStyleController : public QObject {
    Q_OBJECT
public:
    /// Parts of the main window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::AngiogramPanel& panel;
        ui::AngiogramView& view;
        ui::BottomStrip& strip;
    };
    OverlayStyleController(const CaseDocument& document, ViewSync& sync, const Ui& ui, QObject* parent = nullptr);

    void setHiddenWhileHeld(bool held);   ///< hides the vessels as long as the key is held down
    /// Sets the residuals, in whose order W steps through the branches, worst first.
    void setResiduals(std::vector<core::BranchResidual> branches, double millimetersPerPixel);

    /// Returns the drawing style of the vessels, for callers that do not show DRRs.
    ui::OverlayMode lines() const { return isHiddenWhileHeld_ ? ui::OverlayMode::Hidden : style_; }
    WindowLevelMemory& brightness() { return brightness_; }

signals:
    void changed();   ///< emitted when the appearance of the overlay or the inversion of the image changes
    void branchRequested(int branchId);   ///< emitted to select this branch
    void drrRequested(bool wanted);   ///< emitted to switch between a DRR of the vessels and their lines

private:
    void connectOverlay();
    void connectBrightness();
    ui::AngiogramView& image() const;   ///< returns the view with the keyboard focus, or else the shown view
    void redraw();
    void showStyle();
    void cycleStyle();
    QString drrStyleName() const;
    void cycleCutout();
    void changeOpacity(double by);
    void scaleWindow(double factor);
    void showRange(const core::DisplayRange& range);
    void showFullRange();
    void showNextWorst();

    bool hasRadii() const;

    const CaseDocument& document_;
    ViewSync& sync_;
    Ui ui_;
    WindowLevelMemory brightness_;
    ui::OverlayMode style_ = ui::OverlayMode::Centerline;
    bool isDrr_ = false;   ///< whether a DRR is shown instead of `style_`
    bool isHiddenWhileHeld_ = false;
    std::vector<core::BranchResidual> residuals_;
    double millimetersPerPixel_ = 0.0;
    std::size_t nextResidual_ = 0;
};

}   // namespace angiopose::app
