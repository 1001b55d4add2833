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

/// Lets the user edit the lumen mask with brush and scissors in the slices (each stroke is an undo step), and then
/// traces the vessels from the mask on a worker (one further step).
class MaskController : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::TracingPanel& panel;
        ui::SliceModel& slices;
        ui::BottomStrip& strip;
    };
    using Options = std::function<core::VesselTracingOptions()>;   ///< current options of the panel
    MaskController(CaseDocument& document, Options options, const Ui& ui, QObject* parent = nullptr);

    bool isRunning() const { return tracing_.isRunning(); }
    bool isPreparing() const { return copy_.isRunning() || cut_.isRunning(); }
    void trace();
    /// Call after saving. If the latest edits of the mask were not traced and are therefore not in the file, marks the
    /// case as unsaved and shows a note.
    void noteSaved();

signals:
    void reported(const QString& note);
    void failed(const QString& reason);

private:
    void connectTracing();
    void connectTools();
    void connectTool(QAction& action, ui::SliceTool& tool);
    void applySettings(const ui::MaskSettings& settings);
    void updateFromDocument();
    void beginEditing();
    void useDraft(std::shared_ptr<MaskDraft> draft);
    std::shared_ptr<MaskDraft> findDraft() const;
    bool fits(const MaskDraft& draft) const;   ///< returns whether the draft belongs to the lumen of the case
    bool canEdit() const;
    void brush(core::BrushMode mode, const core::SliceGrid& slice, const core::BrushStep& step);
    void endStroke();
    void cut(core::MaskCut cut);
    void applyCut(const core::VoxelIndices& found);
    void applyTrace(const VesselTrace& traced, const std::shared_ptr<MaskDraft>& draft,
                    const MaskDraft::Strokes& strokes);
    void showState();
    int pendingStrokes() const;
    const std::shared_ptr<const core::VoxelMask>& lumen() const { return document_.current().vessels.lumen; }

    CaseDocument& document_;
    Options options_;
    Ui ui_;
    ui::MaskSettings settings_;
    std::array<ui::MaskBrushTool*, 2> brushes_{};
    ui::MaskCutTool* scissors_;
    std::shared_ptr<MaskDraft> draft_;   ///< draft of the lumen of the case; null until it is edited
    std::vector<std::weak_ptr<MaskDraft>> drafts_;   ///< drafts that undo steps reference
    core::VoxelIndices stroke_;   ///< voxels of the current stroke
    core::BrushMode strokeMode_ = core::BrushMode::Paint;
    std::shared_ptr<MaskDraft> cutDraft_;   ///< draft that the active cut reads
    int caseNumber_ = 0;   ///< number of the case to which the drafts belong
    std::shared_ptr<const core::VoxelMask> copiedLumen_;   ///< lumen that is being copied
    Job<std::shared_ptr<core::VoxelMask>> copy_;
    Job<core::VoxelIndices> cut_;
    MaskTracer tracing_;
};

}   // namespace angiopose::app
