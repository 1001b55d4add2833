#pragma once

#include "core/registration/registration.h"
#include "core/vessel/vessel_tree.h"
#include "ui/controls/section.h"
#include "ui/panels/solution_strip.h"
#include "ui/plots/motion_plot.h"
#include "ui/views/verdict_chip.h"

class QTimer;

namespace angiopose::ui {

class ConvergencePlot;
class HistogramPlot;

/// Origin of a pose.
enum class PoseSource {
    Start,
    Edited,
    Run,
    EarlierRegistration,   ///< registered earlier; the inputs may have changed since then
    Tracked
};

/// Assessment of a pose as shown in the result panel.
struct AssessedPose {
    core::RegistrationResult result;   ///< result of the registration, or an assessment of the current pose
    PoseSource source = PoseSource::Start;
    std::vector<double> residualsMm;   ///< residuals of all tree points in use
    double scaleMaximumMm = 0.0;
    double millimetersPerPixel = 0.0;   ///< scale at the vessels
    double assessedFraction = 1.0;   ///< fraction of the tree to which the residuals refer
    double wholeMedianMm = 0.0;   ///< median residual of the whole tree
    core::Messages basis;   ///< parts to which the residuals refer, if not the whole tree: excluded, auxiliary branches
};

/// One-line verdict on the confidence in a pose, shown on the image, above the key figures and in the status strip.
struct FitVerdict {
    VerdictTone tone = VerdictTone::Doubtful;
    QString sentence;
};
FitVerdict assessFit(const AssessedPose& assessed);

/// Panel with three key figures, their interpretation in sentences, and two plots. Displays the values it is given.
class ResultPanel : public QWidget {
    Q_OBJECT
public:
    explicit ResultPanel(QWidget* parent = nullptr);

    void showAssessment(const AssessedPose& assessed, const core::VesselTree& tree);
    void showNothing(const QString& why);
    void setDimmed(bool dimmed);   ///< dims the panel while another pose is previewed
    void startRun();   ///< clears the convergence plot
    void showProgress(const core::IterationReport& report);
    void showHistory(const std::vector<core::IterationReport>& history);
    SolutionStrip& solutions() { return *solutions_; }
    void showMotion(const std::vector<FrameMotion>& motion);   ///< hides the plot if `motion` is empty
    MotionPlot& motion() { return *motion_; }

private:
    QWidget* makeNumber(QLabel*& value, const LocalizedText& caption, const LocalizedText& toolTip);
    void showSentences(const AssessedPose& assessed, const core::VesselTree& tree);
    void reserveSpace(bool isReserved);

    Section* section_;
    SolutionStrip* solutions_;
    Section* residualSection_;
    Section* convergenceSection_;
    Section* motionSection_;
    QLabel* median_ = nullptr;
    QLabel* p95_ = nullptr;
    QLabel* coverage_ = nullptr;
    QLabel* verdict_;
    QLabel* certainLabel_;
    QLabel* doubtfulLabel_;
    HistogramPlot* histogram_;
    ConvergencePlot* convergence_;
    MotionPlot* motion_;
    QTimer* idleTimer_;   ///< fires once the pose has been at rest for a while
};

}   // namespace angiopose::ui
