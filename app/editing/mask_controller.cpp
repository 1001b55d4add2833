#include "app/editing/mask_controller.h"

#include "app/document/edit_case.h"
#include "app/preferences/settings.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/slices/slice_model.h"
#include "ui/slices/tracing_panel.h"
#include "ui/words/language.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace angiopose::app {
namespace {

using core::BrushMode;
using core::VoxelMask;

constexpr double minRadiusMm = 0.2;
constexpr double maxRadiusMm = 25.0;   // the largest ball that can be computed within one display frame

ui::MaskSettings storedSettings()
{
    return {settings::maskOpacity.read(),
            settings::brushRadiusMm.read(),
            settings::isBrush3d.read(),
            settings::brushAboveThreshold.read(),
            static_cast<ui::CutDepth>(std::clamp(settings::cutDepth.read(), 0, 2)),
            settings::cutRangeMm.read()};
}

void store(const ui::MaskSettings& newSettings)
{
    settings::maskOpacity.write(newSettings.opacity);
    settings::brushRadiusMm.write(newSettings.radiusMm);
    settings::isBrush3d.write(newSettings.is3d);
    settings::brushAboveThreshold.write(newSettings.isAboveThreshold);
    settings::cutDepth.write(static_cast<int>(newSettings.depth));
    settings::cutRangeMm.write(newSettings.rangeMm);
}

/// Returns the mask with which editing starts: the lumen, otherwise the voxels above the displayed threshold, otherwise
/// an empty mask.
std::shared_ptr<VoxelMask> startOf(const std::shared_ptr<const VoxelMask>& lumen,
                                   const std::shared_ptr<const core::Volume>& scan, std::optional<double> threshold)
{
    auto mask = std::make_shared<VoxelMask>(lumen ? lumen->geometry : scan->geometry);
    for (std::size_t voxel = 0; voxel < mask->voxels.size(); ++voxel) {
        const bool isIn = lumen ? lumen->voxels[voxel] != 0 : threshold && scan->value(voxel) >= *threshold;
        mask->voxels[voxel] = isIn ? 1 : 0;
    }
    return mask;
}

}   // namespace

MaskController::MaskController(CaseDocument& document, Options options, const Ui& ui, QObject* parent)
    : QObject(parent),
      document_(document),
      options_(std::move(options)),
      ui_(ui),
      scissors_(new ui::MaskCutTool(ui.slices)),
      copy_({[this](const std::shared_ptr<VoxelMask>& mask) {
                 auto draft = std::make_shared<MaskDraft>(mask);
                 draft->recordMatch(std::exchange(copiedLumen_, nullptr), {});
                 drafts_.push_back(draft);
                 useDraft(fits(*draft) ? draft : nullptr);
             },
             [this](const core::Error& error) { emit failed(ui::messageText(error.message)); }}),
      cut_({[this](const core::VoxelIndices& found) { applyCut(found); },
            [this](const core::Error& error) {
                if (const auto draft = std::exchange(cutDraft_, nullptr)) {
                    draft->endReading();
                }
                emit failed(ui::messageText(error.message));
            }})
{
    brushes_ = {new ui::MaskBrushTool(BrushMode::Paint, ui.slices), new ui::MaskBrushTool(BrushMode::Erase, ui.slices)};
    connectTools();
    ui::MaskPanel& panel = ui_.panel.mask();
    ui::WindowActions& actions = ui_.actions;
    panel.bind(*actions[ui::Command::PaintMask], *actions[ui::Command::EraseMask], *actions[ui::Command::CutMask],
               *actions[ui::Command::TraceMask], *actions[ui::Command::ExportMask]);
    connect(&panel, &ui::MaskPanel::settingsEdited, this, &MaskController::applySettings);
    connect(actions[ui::Command::TraceMask], &QAction::triggered, this, &MaskController::trace);
    connect(&ui_.strip, &ui::BottomStrip::stopRequested, &tracing_, &MaskTracer::requestStop);
    connectTracing();
    connect(&document, &CaseDocument::aboutToUndoOrRedo, this, &MaskController::endStroke);
    connect(&document, &CaseDocument::changed, this, &MaskController::updateFromDocument);
    connect(&document, &CaseDocument::stateChanged, this, &MaskController::showState);
    applySettings(storedSettings());
    panel.showSettings(settings_);
    ui::keepTranslated(this, [this] { showState(); });
    updateFromDocument();
}

void MaskController::connectTracing()
{
    connect(&tracing_, &MaskTracer::progressed, this, [this](double fraction) {
        ui_.strip.showProgress(tr("Tracing the mask… %1 %").arg(ui::numberText(100.0 * fraction, 0)), fraction);
    });
    connect(&tracing_, &MaskTracer::ended, this, [this] {
        ui_.strip.showIdle(tr("Ready"));
        showState();
    });
    connect(&tracing_, &MaskTracer::traced, this, &MaskController::applyTrace);
    connect(&tracing_, &MaskTracer::stopped, this, [this] { emit reported(tr("Stopped: the vessels are unchanged")); });
    connect(&tracing_, &MaskTracer::failed, this, &MaskController::failed);
}

void MaskController::connectTools()
{
    connectTool(*ui_.actions[ui::Command::PaintMask], *brushes_[0]);
    connectTool(*ui_.actions[ui::Command::EraseMask], *brushes_[1]);
    connectTool(*ui_.actions[ui::Command::CutMask], *scissors_);
    for (ui::MaskBrushTool* tool : brushes_) {
        connect(tool, &ui::MaskBrushTool::brushed, this, &MaskController::brush);
        connect(tool, &ui::MaskBrushTool::strokeEnded, this, &MaskController::endStroke);
        connect(tool, &ui::MaskBrushTool::radiusRequested, this, [this](double radiusMm) {
            ui::MaskSettings changed = settings_;
            changed.radiusMm = std::clamp(radiusMm, minRadiusMm, maxRadiusMm);
            applySettings(changed);
            ui_.panel.mask().showSettings(changed);
        });
    }
    connect(scissors_, &ui::MaskCutTool::cut, this, &MaskController::cut);
}

void MaskController::connectTool(QAction& action, ui::SliceTool& tool)
{
    ui::bindSliceTool(action, ui_.slices, tool);
    connect(&action, &QAction::toggled, this, [this, &action](bool on) {
        if (on && !ui_.slices.hasScan()) {
            action.setChecked(false);
            emit reported(tr("Open a scan or a label image first."));
        } else if (on) {
            ui_.actions[ui::Command::SlicesLarge]->setChecked(true);
            beginEditing();
        }
    });
}

void MaskController::applySettings(const ui::MaskSettings& newSettings)
{
    settings_ = newSettings;
    store(newSettings);
    ui_.slices.setMaskOpacity(newSettings.opacity);
    for (ui::MaskBrushTool* tool : brushes_) {
        tool->setRadiusMm(newSettings.radiusMm);
    }
}

bool MaskController::fits(const MaskDraft& draft) const
{
    const core::VolumeGeometry* shown = ui_.slices.geometry();
    const core::VolumeGeometry& own = draft.mask()->geometry;
    const bool isHere = lumen() || (shown && core::isSameGrid(*shown, own));
    return isHere && draft.strokesSince(lumen());
}

std::shared_ptr<MaskDraft> MaskController::findDraft() const
{
    for (const std::weak_ptr<MaskDraft>& known : drafts_) {
        if (const auto draft = known.lock(); draft && fits(*draft)) {
            return draft;
        }
    }
    return nullptr;
}

/// Selects the draft of the current lumen, since undo may have restored a lumen that belongs to another draft.
void MaskController::updateFromDocument()
{
    if (const int caseNumber = document_.state().caseNumber; caseNumber != caseNumber_) {
        caseNumber_ = caseNumber;
        drafts_.clear();
        copy_.drop();
        useDraft(nullptr);
    } else if (!draft_ || !fits(*draft_)) {
        useDraft(findDraft());
    }
    if (!draft_ &&
        (ui_.actions[ui::Command::PaintMask]->isChecked() || ui_.actions[ui::Command::EraseMask]->isChecked() ||
         ui_.actions[ui::Command::CutMask]->isChecked())) {
        beginEditing();   // the mode stays on, so that editing starts with the new lumen
    }
    const ui::SliceModel& slices = ui_.slices;
    for (const ui::Command command : {ui::Command::PaintMask, ui::Command::EraseMask, ui::Command::CutMask}) {
        ui_.actions[command]->setEnabled(slices.hasScan());
    }
    ui_.panel.mask().showThreshold(slices.volume() != nullptr);
    showState();
}

void MaskController::useDraft(std::shared_ptr<MaskDraft> draft)
{
    if (draft_) {
        draft_->disconnect(this);
        draft_->disconnect(&ui_.slices);
    }
    if (draft_ && draft_ != draft && !stroke_.empty()) {
        draft_->apply(
            core::makeMaskChange(stroke_));   // reverts the unfinished stroke before another draft becomes current
    }
    if (draft_ != draft) {
        stroke_.clear();
    }
    draft_ = std::move(draft);
    std::erase_if(drafts_, [](const std::weak_ptr<MaskDraft>& known) { return known.expired(); });
    ui_.slices.setDraft(draft_ ? draft_->mask() : nullptr);
    if (draft_) {
        connect(draft_.get(), &MaskDraft::voxelsChanged, &ui_.slices, &ui::SliceModel::notifyDraftChanged);
        connect(draft_.get(), &MaskDraft::strokesChanged, this, &MaskController::showState);
    }
    showState();
}

/// Starts copying the lumen on a worker, since it may be large.
void MaskController::beginEditing()
{
    const core::Vessels& vessels = document_.current().vessels;
    if (draft_ || copy_.isRunning() || (!vessels.lumen && !vessels.scan)) {
        return;
    }
    copiedLumen_ = vessels.lumen;
    copy_.start([lumen = vessels.lumen, scan = vessels.scan,
                 threshold = ui_.slices.previewFrom()](JobLink<double>&) -> core::Result<std::shared_ptr<VoxelMask>> {
        return startOf(lumen, scan, threshold);
    });
}

bool MaskController::canEdit() const
{
    return draft_ && !draft_->isBeingRead() && !document_.isLocked();
}

void MaskController::brush(BrushMode mode, const core::SliceGrid& slice, const core::BrushStep& step)
{
    if (!canEdit()) {
        return;
    }
    const auto& scan = ui_.slices.volume();
    const std::optional<double> threshold = ui_.panel.thresholdShown();
    core::MaskBrush brush{mode, settings_.radiusMm};
    if (mode == BrushMode::Paint && settings_.isAboveThreshold && scan && threshold) {
        brush.scan = scan.get();
        brush.minValue = *threshold;
    }
    const VoxelMask& mask = *draft_->mask();
    const core::VoxelIndices found =
        settings_.is3d ? core::brushVolume(mask, brush, step) : core::brushSlice(mask, slice, brush, step);
    draft_->apply(core::makeMaskChange(found));
    strokeMode_ = mode;
    stroke_.insert(stroke_.end(), found.begin(), found.end());
}

void MaskController::endStroke()
{
    if (stroke_.empty() || !draft_) {
        stroke_.clear();
        if (document_.isLocked()) {
            emit reported(tr("A registration is running. Stop it before editing."));
        }
        return;
    }
    const ui::LocalizedText name = strokeMode_ == BrushMode::Paint ? ui::LocalizedText([] { return tr("Paint mask"); })
                                                                   : ui::LocalizedText([] { return tr("Erase mask"); });
    const core::MaskChange change = core::makeMaskChange(std::exchange(stroke_, {}));
    if (!document_.push(std::make_unique<EditMask>(document_, draft_, change, name))) {
        draft_->apply(change);   // applying it again reverts the change
    }
}

/// Starts a cut on a worker, since cutting a whole volume takes longer than one display frame.
void MaskController::cut(core::MaskCut cut)
{
    if (!canEdit() || cut_.isRunning()) {
        return;
    }
    endStroke();
    cut.halfDepthMm = settings_.depth == ui::CutDepth::Slice   ? 0.0
                      : settings_.depth == ui::CutDepth::Range ? settings_.rangeMm
                                                               : std::numeric_limits<double>::infinity();
    cutDraft_ = draft_;
    cutDraft_->beginReading();
    cut_.start([mask = std::shared_ptr<const VoxelMask>(draft_->mask()), cut = std::move(cut)](
                   JobLink<double>&) -> core::Result<core::VoxelIndices> { return core::cutVoxels(*mask, cut); });
}

/// Applies the cut to the voxels that are still set; undo may have cleared some in the meantime.
void MaskController::applyCut(const core::VoxelIndices& found)
{
    const auto draft = std::exchange(cutDraft_, nullptr);
    draft->endReading();
    if (draft != draft_) {
        return;   // another mask has become current
    }
    core::VoxelIndices there;
    std::ranges::copy_if(found, std::back_inserter(there),
                         [&draft](std::uint32_t voxel) { return draft->mask()->voxels[voxel] != 0; });
    if (there.empty()) {
        emit reported(tr("There is no mask at this position."));
        return;
    }
    const core::MaskChange change = core::makeMaskChange(std::move(there));
    draft->apply(change);
    if (!document_.push(std::make_unique<EditMask>(document_, draft, change, [] { return tr("Cut the mask"); }))) {
        draft->apply(change);   // applying it again reverts the change
    }
}

void MaskController::trace()
{
    if (isRunning() || !canEdit()) {
        return;
    }
    endStroke();
    ui_.strip.showBusy(tr("Tracing the mask…"));
    tracing_.start(draft_, options_());
    showState();
}

void MaskController::applyTrace(const VesselTrace& traced, const std::shared_ptr<MaskDraft>& draft,
                                const MaskDraft::Strokes& strokes)
{
    if (!draft_ || draft != draft_) {
        return;   // another scan or case has been opened in the meantime
    }
    draft_->recordMatch(traced.lumen, strokes);
    const TracedTree tree{{}, traced.input, traced.lumen, traced.tree, LumenOrigin::Edited};
    if (!document_.push(app::applyTrace(document_, tree, [] { return tr("Trace the edited mask"); }))) {
        return;
    }
    const int count = static_cast<int>(traced.tree->branches.size());
    QStringList notes{count == 1 ? tr("Traced: 1 branch.") : tr("Traced: %1 branches.").arg(count)};
    for (const core::Message& warning : traced.warnings) {
        notes << ui::messageText(warning);
    }
    emit reported(ui::joinSentences(notes));
}

int MaskController::pendingStrokes() const
{
    return draft_ ? draft_->strokesSince(lumen()).value_or(0) : 0;
}

void MaskController::noteSaved()
{
    if (pendingStrokes() > 0) {
        document_.markUnsaved();
        emit reported(tr("Saved without the latest mask changes: trace the mask, then save again."));
    }
}

void MaskController::showState()
{
    ui_.actions[ui::Command::TraceMask]->setEnabled(draft_ && pendingStrokes() > 0 && !isRunning() &&
                                                    !document_.isLocked());
    ui_.actions[ui::Command::ExportMask]->setEnabled(lumen() != nullptr);
    ui_.panel.mask().showState({pendingStrokes(), isRunning(), document_.current().vessels.isLumenEdited});
}

}   // namespace angiopose::app
