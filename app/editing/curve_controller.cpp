#include "app/editing/curve_controller.h"

#include "app/document/edit_case.h"
#include "app/jobs/future_result.h"
#include "core/tracing/angiogram/curves/suspect_curves.h"
#include "core/tracing/angiogram/drawing/drawing_guide.h"
#include "ui/actions/window_actions.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/panels/angiogram_panel.h"
#include "ui/panels/curve_edit_bar.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/bind_tool.h"

#include <QtConcurrentRun>

#include <algorithm>

namespace angiopose::app {
namespace {

std::shared_ptr<ui::CurveGuide> makeGround(const TraceRequest& request)
{
    const core::ImageF& frame = request.angiogram->frames[static_cast<std::size_t>(request.frame)];
    core::DrawingGuide ground =
        core::computeDrawingGuide(frame, request.angiogram->polarity, request.options, request.angiogram->shutter);
    if (ground.vesselness.isEmpty()) {
        return nullptr;
    }
    return std::make_shared<ui::CurveGuide>(ui::CurveGuide{core::LiveWire(ground.vesselness), std::move(ground.opacity),
                                                           request.options.maxVesselRadiusPx});
}

/// Wraps the curves in a shared pointer; null if there are none.
SharedCenterline shared(const core::Centerline2d& curves)
{
    return curves.curves.empty() ? nullptr : std::make_shared<const core::Centerline2d>(curves);
}

bool hasCurve(const core::Centerline2d& curves, int id)
{
    return std::ranges::find(curves.curves, id, &core::Curve2d::id) != curves.curves.end();
}

}   // namespace

CurveController::CurveController(const AngiogramParts& parts, QObject* parent)
    : QObject(parent),
      document_(parts.document),
      target_(parts.target),
      actions_(parts.actions),
      panel_(parts.panel),
      view_(parts.view),
      dialogParent_(parts.dialogParent),
      notifications_(parts.notifications),
      tool_(new ui::EditCurvesTool(view_)),
      bar_(new ui::CurveEditBar)
{
    view_.addBar(bar_);
    bar_->hide();
    connectTool();
    connect(&document_, &CaseDocument::changed, this, &CurveController::updateFromDocument);
    connect(&target_, &TargetProvider::changed, this, &CurveController::updateFromDocument);
    connect(&view_, &ui::AngiogramView::toolChanged, this, &CurveController::updateFromDocument);
    connect(&edgeData_, &QFutureWatcherBase::finished, this, [this] {
        if (edgeDataRequest_) {   // otherwise the user has left the tool and the result is obsolete
            tool_->setGuide(takeResult(edgeData_));
        }
    });
    updateFromDocument();
}

void CurveController::connectTool()
{
    QAction* mode = actions_[ui::Command::EditVessels];
    ui::bindTool(*mode, view_, *tool_);
    connect(mode, &QAction::toggled, this, [this](bool on) {
        bar_->setVisible(on);
        view_.setFocus();
    });
    connect(&panel_, &ui::AngiogramPanel::editingRequested, mode, [mode] { mode->setChecked(true); });
    connect(tool_, &ui::EditCurvesTool::activated, this, [this] {
        actions_[ui::Command::Cine]->setChecked(false);
        shownCurves_.reset();
        updateFromDocument();
    });
    connect(tool_, &ui::EditCurvesTool::edited, this, &CurveController::applyEdit);
    connect(tool_, &ui::EditCurvesTool::suspectAccepted, this, &CurveController::accept);
    connect(tool_, &ui::EditCurvesTool::deviceToggled, this, &CurveController::setExcluded);
    connect(tool_, &ui::EditCurvesTool::editChanged, bar_, &ui::CurveEditBar::showEdit);
    connect(bar_, &ui::CurveEditBar::editChosen, this, [this](ui::CurveEdit edit) {
        tool_->setEdit(edit);
        view_.setFocus();   // gives the image the keyboard focus, since the mode has keys of its own
    });
    connect(bar_, &ui::CurveEditBar::finishRequested, this, [this] { view_.setTool(nullptr); });
    connect(bar_, &ui::CurveEditBar::traceAgainRequested, this, &CurveController::confirmRetrace);
    connect(bar_, &ui::CurveEditBar::trackDeviceRequested, this, &CurveController::trackDevice);
    connect(actions_[ui::Command::TraceAgain], &QAction::triggered, this, &CurveController::confirmRetrace);
}

void CurveController::updateFromDocument()
{
    const core::Case& current = document_.current();
    const bool isGiven = core::givenTargetOf(current.shown()) != nullptr;
    actions_[ui::Command::EditVessels]->setEnabled(current.shown().angiogram != nullptr);
    actions_[ui::Command::TraceAgain]->setEnabled(isGiven);
    bar_->setEdited(isGiven);
    if (view_.tool() != tool_) {
        releaseEdgeData();
        return;
    }
    if (!current.shown().angiogram) {
        view_.setTool(nullptr);
        return;
    }
    showCurves();
    requestEdgeData();
}

void CurveController::showCurves()
{
    tool_->setReady(target_.current() || target_.problem().has_value());
    const std::vector<int>& accepted = document_.current().shown().target.acceptedCurveIds;
    const SharedCenterline devices = core::devicesOf(document_.current().shown());
    const bool isShown = shownCurves_ == target_.current() && shownDevices_ == devices;
    if (shownCurves_ && isShown && shownAccepted_ == accepted) {
        return;   // nothing changed, so an edit in progress may continue
    }
    shownCurves_ = target_.current();
    shownDevices_ = devices;
    shownAccepted_ = accepted;
    const core::SeparatedCurves curves = currentCurves();
    const ui::CurveMarks marks{suspects(), core::curveIds(curves.devices)};
    tool_->showCurves(core::allCurves(curves), marks);
    bar_->showCurves({static_cast<int>(curves.vessels.curves.size()), static_cast<int>(marks.suspects.size()),
                      static_cast<int>(marks.devices.size())});
}

core::SeparatedCurves CurveController::currentCurves() const
{
    core::SeparatedCurves curves;
    curves.vessels = target_.current() ? *target_.current() : core::Centerline2d{};
    if (const SharedCenterline devices = core::devicesOf(document_.current().shown())) {
        curves.devices = *devices;
    }
    return curves;
}

std::vector<int> CurveController::suspects() const
{
    if (target_.trace()) {
        return target_.trace()->suspectIds;
    }
    const core::Case& current = document_.current();
    if (!target_.current() || !current.shown().angiogram) {
        return {};
    }
    std::vector<int> ids = core::suspectCurves(
        *target_.current(), std::max(current.shown().angiogram->width(), current.shown().angiogram->height()));
    std::erase_if(ids, [&](int id) {
        return std::ranges::find(current.shown().target.acceptedCurveIds, id) !=
               current.shown().target.acceptedCurveIds.end();
    });
    return ids;
}

void CurveController::requestEdgeData()
{
    const core::Case& current = document_.current();
    const TraceRequest request{current.shown().angiogram, current.shown().frame, core::traceOptionsOf(current.shown())};
    const bool exists = request.frame >= 0 && request.frame < request.angiogram->frameCount();
    if (!exists || edgeDataRequest_ == request) {
        return;
    }
    edgeDataRequest_ = request;
    tool_->setGuide(nullptr);
    edgeData_.setFuture(QtConcurrent::run([request] { return makeGround(request); }));
}

void CurveController::releaseEdgeData()
{
    if (!edgeDataRequest_) {
        return;
    }
    edgeDataRequest_.reset();
    edgeData_.setFuture({});   // discards a pending result
    tool_->setGuide(nullptr);
}

/// Returns the IDs of the curves accepted in this frame; empty if the frame has just been traced, since the IDs stored
/// in the case refer to other curves.
std::vector<int> CurveController::acceptedIds() const
{
    return target_.trace() ? std::vector<int>() : document_.current().shown().target.acceptedCurveIds;
}

void CurveController::applyEdit(const core::Centerline2d& curves, const ui::LocalizedText& undoText)
{
    const core::SeparatedCurves edited = core::separateDevices(curves, core::devicesAfterEdit(currentCurves(), curves));
    if (edited.vessels.pointCount() == 0) {
        notifications_.showNote(tr("At least one curve must remain as the registration target."));
        return;
    }
    std::vector<int> accepted = acceptedIds();
    std::erase_if(accepted, [&](int id) { return !hasCurve(edited.vessels, id); });
    push({{}, shared(edited.vessels), {}, std::move(accepted), shared(edited.devices)}, undoText);
}

void CurveController::accept(int curveId)
{
    std::vector<int> accepted = acceptedIds();
    accepted.push_back(curveId);
    push({{}, target_.current(), {}, std::move(accepted), core::devicesOf(document_.current().shown())},
         [] { return tr("Keep suspect curve"); });
}

/// Marks a curve as a catheter or guidewire, or as a vessel; a vessel is also no longer suspect.
void CurveController::setExcluded(int curveId, bool isExcluded)
{
    const core::SeparatedCurves before = currentCurves();
    std::vector<int> deviceIds = core::curveIds(before.devices);
    std::vector<int> accepted = acceptedIds();
    std::erase(accepted, curveId);
    if (isExcluded) {
        deviceIds.push_back(curveId);
    } else {
        std::erase(deviceIds, curveId);
        accepted.push_back(curveId);
    }
    const core::SeparatedCurves curves = core::separateDevices(core::allCurves(before), deviceIds);
    if (curves.vessels.curves.empty()) {
        notifications_.showNote(
            tr("If only a guidewire is visible, use the method “Guidewire or catheter”, which uses every curve."));
        return;
    }
    push({{}, shared(curves.vessels), {}, std::move(accepted), shared(curves.devices)},
         isExcluded ? ui::LocalizedText([] { return tr("Mark curve as device"); })
                    : ui::LocalizedText([] { return tr("Mark curve as vessel"); }));
}

void CurveController::trackDevice()
{
    core::RegistrationOptions options = document_.current().options;
    if (options.method != "wire") {
        options.method = "wire";
        document_.push(std::make_unique<ChangeOptions>(document_, ChangeOptions::Values{options},
                                                       [] { return tr("Track device"); }));
    }
    actions_[ui::Command::Register]->trigger();
}

void CurveController::push(core::GivenTarget target, const ui::LocalizedText& undoText)
{
    const core::Case& current = document_.current();
    const auto formerFrame = current.shown().target.editedFrame;
    const int frame = current.shown().frame;
    target.editedFrame = frame;
    const bool isPushed = document_.push(
        std::make_unique<ChangeTarget>(document_, ChangeTarget::Values{std::move(target), std::nullopt, {}}, undoText));
    if (isPushed && formerFrame && formerFrame != frame) {
        notifications_.showNote(
            tr("The edited curves of frame %1 were replaced. Undo restores them.").arg(*formerFrame + 1));
    }
}

void CurveController::confirmRetrace()
{
    if (!core::givenTargetOf(document_.current().shown())) {
        return;
    }
    auto* question = new ui::QuestionDialog(
        {tr("Trace this frame again?"), tr("Its edited or imported curves will be replaced. Undo restores them."), {}},
        {tr("Trace again"), tr("Keep the curves")}, &dialogParent_);
    question->setObjectName(QStringLiteral("traceAgainQuestion"));
    connect(question, &ui::QuestionDialog::answered, this, [this](int index) {
        if (index == 0) {
            retrace();
        }
    });
    question->open();
}

void CurveController::retrace()
{
    document_.push(std::make_unique<ChangeTarget>(
        document_, ChangeTarget::Values{core::GivenTarget{}, std::nullopt, {}}, [] { return tr("Trace again"); }));
}

}   // namespace angiopose::app
