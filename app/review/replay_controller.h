#pragma once

#include "app/document/case_document.h"
#include "app/showing/pose_preview.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace angiopose::ui {
class BottomStrip;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Shows poses temporarily without changing the case: the convergence of the last registration, the swing along the
/// least constrained direction, and the alternative solutions. Any change to the case ends the animation.
class ReplayController : public QObject {
    Q_OBJECT
public:
    ReplayController(CaseDocument& document, PosePreview& preview, ui::WindowActions& actions, ui::BottomStrip& strip,
                     QObject* parent = nullptr);

    void setUncertainty(const std::optional<core::PoseUncertainty>& uncertainty) { uncertainty_ = uncertainty; }

    void showCurrentPose();   ///< shows the pose of the case instead of an alternative solution
    void showSolution(std::size_t index);   ///< shows a solution; index 0 is the pose of the case
    void acceptSolution();   ///< makes the shown solution the pose of the case

signals:
    void solutionShown();   ///< emitted when a solution is shown, which should end other animations
    void solutionChanged(std::size_t index);

private:
    struct Swing {
        core::Vector6d perSigma = core::Vector6d::Zero();   ///< pose change per standard deviation, rad and mm
        double sigmaMm = 0.0;
        QString statusText;
    };
    std::optional<Swing> swing() const;
    void setReplaying(bool on);
    void showStep();
    void setSwinging(bool on);
    void showSwing();
    void showNextSolution();

    CaseDocument& document_;
    PosePreview& preview_;
    ui::WindowActions& actions_;
    ui::BottomStrip& strip_;
    std::optional<core::PoseUncertainty> uncertainty_;
    QTimer replayTimer_;
    QTimer swingTimer_;
    std::size_t step_ = 0;
    int phase_ = 0;
    std::size_t solution_ = 0;   ///< 0 for the pose of the case, k for the k-th alternative solution
};

}   // namespace angiopose::app
