#pragma once

#include "app/editing/mask_draft.h"
#include "app/editing/mask_tracing.h"
#include "app/jobs/job.h"
#include "ui/slices/mask_panel.h"
#include "ui/slices/mask_tools.h"

#include <array>
#include <functional>

namespace angiopose::ui {
class BottomStrip;
class SliceModel;
class TracingPanel;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// The lumen mask edited by hand: brush and scissors in the slices, each stroke a step of undo; then the vessels are
/// traced from it, on a worker, as one step more.
class MaskController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::TracingPanel& panel;
        ui::SliceModel& slices;
        ui::BottomStrip& strip;
    };
    using Options = std::function<core::VesselTracingOptions()>;   ///< as the panel has them
    MaskController(CaseDocument& document, Options options, const Ui& ui, QObject* parent = nullptr);

    bool isRunning() const { return tracing_.isRunning(); }
    bool isPreparing() const { return copy_.isRunning() || cut_.isRunning(); }
    void trace();
    /// The case was saved: what the vessels do not know of the mask is not in it.
    void noteSaved();

signals:
    void reported(const QString& note);
    void failed(const QString& reason);

private:
    void connectTracing();
    void connectTools();
    void connectTool(QAction& action, ui::SliceTool& tool);
    void takeSettings(const ui::MaskSettings& settings);
    void followDocument();
    void beginEditing();
    void useDraft(std::shared_ptr<MaskDraft> draft);
    std::shared_ptr<MaskDraft> knownDraft() const;
    bool fits(const MaskDraft& draft) const;   ///< it stands for the case's lumen
    bool canEdit() const;
    void brush(core::MaskAim aim, const core::SliceGrid& slice, const core::BrushStep& step);
    void endStroke();
    void cut(core::MaskCut cut);
    void takeCut(const core::VoxelPlaces& found);
    void takeTrace(const VesselTrace& traced, const std::shared_ptr<MaskDraft>& draft,
                   const MaskDraft::Strokes& strokes);
    void showState();
    int openStrokes() const;
    const std::shared_ptr<const core::VoxelMask>& lumen() const { return document_.current().vessels.lumen; }

    CaseDocument& document_;
    Options options_;
    Ui ui_;
    ui::MaskSettings settings_;
    std::array<ui::MaskBrushTool*, 2> brushes_{};
    ui::MaskCutTool* scissors_;
    std::shared_ptr<MaskDraft> draft_;   ///< of the case's lumen; null until it is edited
    std::vector<std::weak_ptr<MaskDraft>> drafts_;   ///< that steps of undo know
    core::VoxelPlaces stroke_;   ///< of the stroke under way
    core::MaskAim strokeAim_ = core::MaskAim::Paint;
    std::shared_ptr<MaskDraft> cutDraft_;   ///< that the cut under way reads
    int caseNumber_ = 0;   ///< that the drafts belong to
    std::shared_ptr<const core::VoxelMask> copied_;   ///< of the copy under way
    Job<std::shared_ptr<core::VoxelMask>> copy_;
    Job<core::VoxelPlaces> cut_;
    MaskTracing tracing_;
};

}   // namespace angiopose::app
