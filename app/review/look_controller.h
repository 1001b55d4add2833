#pragma once

#include "app/document/case_document.h"
#include "app/review/brightness_memory.h"
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

/// How the overlay lies on the angiogram: style, opacity, depth cue, swipe and lens, brightness, and the way to the
/// branch that fits worst. Nothing here changes the case.
class LookController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::AngiogramPanel& panel;
        ui::AngiogramView& view;
        ui::BottomStrip& strip;
    };
    LookController(const CaseDocument& document, ViewSync& sync, const Ui& ui, QObject* parent = nullptr);

    void holdHidden(bool held);   ///< the vessels, while the key is held
    /// What W goes through, from the worst branch on.
    void knowResiduals(std::vector<core::BranchResidual> branches, double millimetersPerPixel);

    /// As what the vessels are drawn, where nobody makes radiographs of them.
    ui::OverlayMode lines() const { return heldHidden_ ? ui::OverlayMode::Hidden : style_; }
    BrightnessMemory& brightness() { return brightness_; }

signals:
    void changed();   ///< how the overlay looks, or the image's inversion
    void branchWanted(int branchId);   ///< to be selected
    void radiographWanted(bool wanted);   ///< of the vessels, in place of their lines

private:
    void connectOverlay();
    void connectBrightness();
    ui::AngiogramView& image() const;   ///< that has the keys; else the shown one
    void redraw();
    void showStyle();
    void nextStyle();
    QString radiographWords() const;
    void nextCutout();
    void changeOpacity(double by);
    void scaleWindow(double factor);
    void showRange(const core::DisplayRange& range);
    void showFullRange();
    void showNextWorst();

    bool hasRadii() const;

    const CaseDocument& document_;
    ViewSync& sync_;
    Ui ui_;
    BrightnessMemory brightness_;
    ui::OverlayMode style_ = ui::OverlayMode::Centerline;
    bool isRadiograph_ = false;   ///< in place of `style_`
    bool heldHidden_ = false;
    std::vector<core::BranchResidual> worstFirst_;
    double millimetersPerPixel_ = 0.0;
    std::size_t nextWorst_ = 0;
};

}   // namespace angiopose::app