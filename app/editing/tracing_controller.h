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

/// Tracing the vessels of a scan by hand-set threshold, seeds and limits. What is set is a draft until a trace has
/// succeeded: then tree and settings enter the case as one step.
class TracingController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::TracingPanel& panel;
        ui::SliceModel& slices;
        ui::SlicesPage& slicesPage;
        ui::BottomStrip& strip;
    };
    TracingController(CaseDocument& document, const Ui& ui, QObject* parent = nullptr);

    const core::VesselTracingOptions& draft() const { return draft_; }   ///< as the panel has them
    bool isRunning() const { return job_.isRunning(); }
    void start();
    void stop() { job_.stop(); }
    void dropPick() { setPick(ui::TracingPick::Nothing); }   ///< a click in a slice sets no point any more
    void addPoint(ui::TracingPick kind, const Eigen::Vector3d& pointInPatient);
    void knowWarnings(const core::Messages& warnings);   ///< of tracing the scan of the case

signals:
    void traced(const QString& note);
    void failed(const QString& reason);

private:
    void connectPanel();
    void followDocument();
    void showWhyNot();
    void setDraft(const core::VesselTracingOptions& draft);
    void setPick(ui::TracingPick pick);
    void showPreview();
    void findThreshold();   ///< that "automatic" comes to, on a worker
    void finish(const VesselTrace& result);
    void ended();
    void seedOtherLumen();
    QString whyNot() const;

    CaseDocument& document_;
    Ui ui_;
    LabelController labels_;
    VesselTraceJob job_;
    core::VesselTracingOptions draft_;
    core::VesselInput shownInput_;
    std::shared_ptr<const core::Volume> shownVolume_;   ///< that the vessels are traced from
    CaseState startedFrom_;
    core::InputFile source_;   ///< of the trace under way
    core::Messages warnings_;
    std::optional<Eigen::Vector3d> otherLumen_;   ///< that the warnings tell of
    std::shared_ptr<const core::VesselTree> warnedOf_;
    std::optional<VesselTrace> waiting_;   ///< for the end of a registration
    ui::TracingPick pick_ = ui::TracingPick::Nothing;
    Job<double> level_;
};

}   // namespace angiopose::app