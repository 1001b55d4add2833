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

/// How a pose came about.
enum class PoseSource {
    Start,
    Edited,
    Run,
    EarlierRun,   ///< a run found it, but what it was fitted to may have changed since
    Followed
};

/// What the result panel shows of one judged pose.
struct JudgedPose {
    core::RegistrationResult result;   ///< of the run, or a judgement of the pose as it is
    PoseSource source = PoseSource::Start;
    std::vector<double> residualsMm;   ///< every used tree point
    double scaleMaximumMm = 0.0;
    double millimetersPerPixel = 0.0;   ///< at the vessels
    double judgedShare = 1.0;   ///< of the tree, that the distances are over
    double wholeMedianMm = 0.0;   ///< over all of it
    core::Messages basis;   ///< of the distances, where that is not the whole tree; excluded and auxiliary branches
};

/// How far a pose is to be trusted, in one line: on the image, above the numbers and in the status.
struct FitVerdict {
    VerdictTone tone = VerdictTone::Doubtful;
    QString words;
};
FitVerdict verdictOf(const JudgedPose& judged);

/// Three numbers, what they mean in words, and the two plots. Shows what it is told.
class ResultPanel : public QWidget {
    Q_OBJECT
public:
    explicit ResultPanel(QWidget* parent = nullptr);

    void showJudgement(const JudgedPose& judged, const core::VesselTree& tree);
    void showNothing(const QString& why);
    void setDimmed(bool dimmed);   ///< while another pose is looked at
    void startRun();   ///< empties the convergence plot
    void showProgress(const core::IterationReport& report);
    void showHistory(const std::vector<core::IterationReport>& history);
    SolutionStrip& solutions() { return *solutions_; }
    void showMotion(const std::vector<FrameMotion>& motion);   ///< hidden while there is none
    MotionPlot& motion() { return *motion_; }

private:
    QWidget* makeNumber(QLabel*& value, const Words& caption, const Words& toolTip);
    void showSentences(const JudgedPose& judged, const core::VesselTree& tree);
    void keepRooms(bool areKept);

    Section* section_;
    SolutionStrip* solutions_;
    Section* residualSection_;
    Section* convergenceSection_;
    Section* motionSection_;
    QLabel* median_ = nullptr;
    QLabel* p95_ = nullptr;
    QLabel* coverage_ = nullptr;
    QLabel* verdict_;
    QLabel* certain_;
    QLabel* doubtful_;
    HistogramPlot* histogram_;
    ConvergencePlot* convergence_;
    MotionPlot* motion_;
    QTimer* rest_;   ///< the pose has not been moved for a while
};

}   // namespace angiopose::ui