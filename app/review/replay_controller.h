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

/// Animated poses, shown but never written: convergence of the last registration, the swing along the least constrained
/// direction, and the other solutions of the last registration. Any change of the case ends the animation.
class ReplayController : public QObject {
    Q_OBJECT
public:
    ReplayController(CaseDocument& document, PosePreview& preview, ui::WindowActions& actions, ui::BottomStrip& strip,
                     QObject* parent = nullptr);

    void knowUncertainty(const std::optional<core::PoseUncertainty>& uncertainty) { uncertainty_ = uncertainty; }

    void showItself();   ///< shows the pose of the case instead of another solution
    void showSolution(std::size_t index);   ///< 0: the pose of the case
    void takeSolution();   ///< makes the shown solution the pose of the case

signals:
    void solutionShown();   ///< other animations should end
    void solutionChanged(std::size_t index);

private:
    struct Swing {
        core::Vector6d perSigma = core::Vector6d::Zero();   ///< change of the pose per standard deviation: rad, mm
        double sigmaMm = 0.0;
        QString words;
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
    std::size_t solution_ = 0;   ///< 0: the pose of the case, k: the k-th other solution
};

}   // namespace angiopose::app