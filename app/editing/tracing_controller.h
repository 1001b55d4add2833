#pragma once

#include "app/document/case_document.h"
#include "app/editing/label_controller.h"
#include "app/jobs/vessel_trace_job.h"
#include "ui/slices/tracing_panel.h"

#include <QObject>

namespace angiopose::ui {
class BottomStrip;
class SliceModel;
class SlicesPage;
class TracingPanel;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Traces the vessels of a scan with user-defined threshold, seeds and limits. The settings are a draft until a trace
/// succeeds; then the tree and the settings enter the case as one undo step.
class TracingController : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::TracingPanel& panel;
        ui::SliceModel& slices;
        ui::SlicesPage& slicesPage;
        ui::BottomStrip& strip;
    };
    TracingController(CaseDocument& document, const Ui& ui, QObject* parent = nullptr);

    const core::VesselTracingOptions& draft() const { return draft_; }   ///< current options of the panel
    bool isRunning() const { return job_.isRunning(); }
    void start();
    void stop() { job_.stop(); }
    void endPicking() { setPick(ui::TracingPick::Nothing); }   ///< ends the mode in which clicks in a slice set points
    void addPoint(ui::TracingPick kind, const Eigen::Vector3d& pointInPatient);
    void setWarnings(const core::Messages& warnings);   ///< shows the warnings from tracing the scan of the case

signals:
    void traced(const QString& note);
    void failed(const QString& reason);

private:
    void connectPanel();
    void updateFromDocument();
    void showBlockingReason();
    void setDraft(const core::VesselTracingOptions& draft);
    void setPick(ui::TracingPick pick);
    void showPreview();
    void findThreshold();   ///< computes the automatic threshold on a worker
    void finish(const VesselTrace& result);
    void ended();
    void seedFalseLumen();
    QString blockingReason() const;

    CaseDocument& document_;
    Ui ui_;
    LabelController labels_;
    VesselTraceJob job_;
    core::VesselTracingOptions draft_;
    core::VesselInput shownInput_;
    std::shared_ptr<const core::Volume> shownVolume_;   ///< scan in which the vessels are traced
    CaseState startedFrom_;
    core::InputFile source_;   ///< input of the current trace
    core::Messages warnings_;
    std::optional<Eigen::Vector3d> falseLumen_;   ///< position in the possible false lumen, from the warnings
    std::shared_ptr<const core::VesselTree> warnedTree_;
    std::optional<VesselTrace> pendingResult_;   ///< result of a trace, held back until registration ends
    ui::TracingPick pick_ = ui::TracingPick::Nothing;
    Job<double> thresholdJob_;
};

}   // namespace angiopose::app
