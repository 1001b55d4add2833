#include "app/editing/subtraction_controller.h"

#include "app/document/edit_case.h"
#include "app/jobs/free_on_worker.h"
#include "app/jobs/future_result.h"
#include "app/jobs/guarded.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/angiogram_panel.h"
#include "ui/panels/bottom_strip.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/bind_tool.h"
#include "ui/words/message_text.h"
#include "ui/words/retranslation.h"

#include <QtConcurrentRun>

#include <algorithm>

namespace angiopose::app {
namespace {

using namespace std::chrono_literals;

core::Result<std::shared_ptr<const core::Angiogram>> make(const core::Angiogram& stored,
                                                          const core::RunProcessing& processing,
                                                          const std::atomic<bool>& stop)
{
    return guarded<std::shared_ptr<const core::Angiogram>>(
        [&]() -> core::Result<std::shared_ptr<const core::Angiogram>> {
            auto run = core::processRun(stored, processing, [&stop] { return stop.load(); });
            if (!run) {
                return run.error();
            }
            return freeOnWorker(std::make_shared<const core::Angiogram>(std::move(run).value()));
        });
}

}   // namespace

SubtractionController::SubtractionController(const AngiogramParts& parts, QObject* parent)
    : QObject(parent),
      document_(parts.document),
      sync_(parts.sync),
      actions_(parts.actions),
      panel_(parts.panel),
      view_(parts.view),
      strip_(parts.strip),
      notifications_(parts.notifications),
      shiftTool_(new ui::MaskShiftTool(view_))
{
    connectCommands();
    connectMasks();
    connectShift();
    connect(&panel_, &ui::AngiogramPanel::treatmentEdited, this, &SubtractionController::change);
    connect(&run_, &QFutureWatcherBase::finished, this, &SubtractionController::publish);
    connect(&document_, &CaseDocument::changed, this, &SubtractionController::updateFromDocument);
    connect(&sync_, &ViewSync::opacificationMeasured, this, &SubtractionController::showState);
    ui::keepTranslated(this, [this] { updateFromDocument(); });
}

SubtractionController::~SubtractionController()
{
    if (stop_) {
        *stop_ = true;
    }
}

void SubtractionController::connectCommands()
{
    connect(actions_[ui::Command::Subtract], &QAction::triggered, this, [this](bool on) {
        core::RunProcessing wanted = document_.current().shown().processing;
        wanted.isSubtracted = on;
        change(wanted, [on] { return on ? tr("Subtract mask") : tr("Show native frames"); });
    });
    connect(actions_[ui::Command::Composite], &QAction::triggered, this, [this](bool on) {
        core::RunProcessing wanted = document_.current().shown().processing;
        wanted.isComposite = on;
        change(wanted, [on] { return on ? tr("Peak-opacification image") : tr("Single frames"); });
    });
}

void SubtractionController::connectMasks()
{
    connect(actions_[ui::Command::SetMaskFrame], &QAction::triggered, this,
            [this] { markMasks({sync_.shownFrame()}); });
    connect(&strip_, &ui::BottomStrip::maskRangeMarked, this, [this](int first, int last) {
        std::vector<int> frames;
        for (int frame = first; frame <= last; ++frame) {
            frames.push_back(frame);
        }
        markMasks(frames);
    });
}

void SubtractionController::markMasks(const std::vector<int>& frames)
{
    if (!document_.current().shown().angiogram) {
        return;
    }
    core::RunProcessing wanted = document_.current().shown().processing;
    wanted.plan.maskFrames = frames;
    wanted.plan.interval.reset();
    wanted.isSubtracted = true;
    change(wanted, [] { return tr("Choose mask frames"); });
}

void SubtractionController::connectShift()
{
    ui::bindTool(*actions_[ui::Command::ShiftMask], view_, *shiftTool_);
    connect(&panel_, &ui::AngiogramPanel::pixelShiftRequested, this, [this] {
        actions_[ui::Command::ShiftMask]->setChecked(true);
        view_.setFocus();
    });
    connect(shiftTool_, &ui::MaskShiftTool::activated, this, &SubtractionController::beginShift);
    connect(shiftTool_, &ui::MaskShiftTool::shifted, this, [this](const Eigen::Vector2d& shiftPx) {
        isShiftFound_ = true;
        idleTimer_.stop();
        previewShift(shiftPx);
    });
    connect(shiftTool_, &ui::MaskShiftTool::shiftFinished, &idleTimer_, qOverload<>(&QTimer::start));
    connect(shiftTool_, &ui::MaskShiftTool::ended, this, &SubtractionController::applyShift);
    idleTimer_.setSingleShot(true);
    idleTimer_.setInterval(600ms);
    connect(&idleTimer_, &QTimer::timeout, this, &SubtractionController::applyShift);
    connect(&preview_, &QFutureWatcherBase::finished, this, &SubtractionController::showPreview);
}

void SubtractionController::change(const core::RunProcessing& wanted, const ui::LocalizedText& undoText)
{
    const core::Case& current = document_.current();
    if (!current.shown().angiogram || document_.isLocked()) {
        notifications_.showNote(current.shown().angiogram ? tr("A registration is running. Stop it before editing.")
                                                          : tr("Open an angiogram first."));
        showState();
        return;
    }
    request_ = Request{core::storedRunOf(current.shown()), wanted, undoText};
    if (wanted == current.shown().processing) {
        request_.reset();   // the requested processing is the current one, so that nothing needs to be computed
    } else if (!wanted.changesFrames()) {
        applyRun(*std::exchange(request_, std::nullopt), nullptr);
    } else if (const SharedRun known = treatedRuns_.find(request_->stored, wanted)) {
        applyRun(*std::exchange(request_, std::nullopt), known);
    } else {
        compute();
    }
    showState();
}

void SubtractionController::compute()
{
    if (run_.isRunning()) {
        *stop_ = true;   // `publish` starts the new request once the worker has stopped
        return;
    }
    computing_ = request_;
    stop_ = std::make_shared<std::atomic<bool>>(false);
    run_.setFuture(QtConcurrent::run([stored = request_->stored, processing = request_->processing, stop = stop_] {
        return make(*stored, processing, *stop);
    }));
}

void SubtractionController::publish()
{
    const Outcome outcome = takeResult(run_);
    const Request done = *std::exchange(computing_, std::nullopt);
    const auto& stored = core::storedRunOf(document_.current().shown());
    if (outcome && done.stored == stored) {   // otherwise another run has been opened in the meantime
        treatedRuns_.remember(done.stored, done.processing, outcome.value());
    }
    if (request_ && request_->stored != stored) {
        request_.reset();
    }
    if (!request_) {
        showState();
        return;
    }
    if (!(request_->stored == done.stored && request_->processing == done.processing)) {
        compute();
        return;
    }
    request_.reset();
    if (!outcome) {
        notifications_.showNote(ui::messageText(outcome.error().message));
    } else {
        applyRun(done, outcome.value());
    }
    showState();
}

void SubtractionController::applyRun(const Request& request, const SharedRun& run)
{
    document_.push(std::make_unique<ChangeTreatment>(
        document_,
        ChangeTreatment::Values{
            request.processing, run ? run : request.stored, run ? request.stored : nullptr, std::nullopt, {}},
        request.undoText));
}

/// Starts the manual pixel shift from the shift of the case, or from the automatic one of the shown frame.
void SubtractionController::beginShift()
{
    actions_[ui::Command::Cine]->setChecked(false);
    const auto& given = document_.current().shown().processing.plan.maskShiftPx;
    isShiftFound_ = given.has_value();
    isPreviewRangeChanged_ = true;
    initialShift_ = given.value_or(Eigen::Vector2d(Eigen::Vector2d::Zero()));
    shiftTool_->showShift(initialShift_);
    previewShift(given);
}

void SubtractionController::previewShift(const std::optional<Eigen::Vector2d>& shiftPx)
{
    pendingPreview_ = document_.current().shown().processing.plan;
    pendingPreview_->maskShiftPx = shiftPx;
    startPreview();
}

void SubtractionController::startPreview()
{
    const core::Case& current = document_.current();
    if (!pendingPreview_ || preview_.isRunning() || !current.shown().angiogram) {
        return;
    }
    preview_.setFuture(QtConcurrent::run(
        [stored = core::storedRunOf(current.shown()), plan = *std::exchange(pendingPreview_, std::nullopt),
         frame = current.shown().frame, polarity = current.shown().angiogram->polarity]() -> PreviewFrame {
            auto picture = core::subtractFrame(stored->frames, polarity, plan, frame);
            if (!picture) {
                return picture.error();
            }
            return std::make_shared<const core::SubtractedFrame>(std::move(picture).value());
        }));
}

void SubtractionController::showPreview()
{
    const PreviewFrame picture = takeResult(preview_);
    if (view_.tool() == shiftTool_) {
        if (!picture) {
            notifications_.showNote(ui::messageText(picture.error().message));
            view_.setTool(nullptr);
            return;
        }
        view_.setFrame(picture.value()->frame);
        if (std::exchange(isPreviewRangeChanged_, false)) {
            view_.autoWindowLevel();
        }
        if (!std::exchange(isShiftFound_, true)) {
            shiftTool_->showShift(picture.value()->maskShiftPx);
            initialShift_ = picture.value()->maskShiftPx;
        }
    }
    startPreview();
}

void SubtractionController::applyShift()
{
    idleTimer_.stop();
    if (shiftTool_->shiftPx() == initialShift_) {
        sync_.showFrame(document_.current().shown().frame);   // replaces the preview by the actual frame
        view_.autoWindowLevel();
        return;
    }
    initialShift_ = shiftTool_->shiftPx();
    core::RunProcessing wanted = document_.current().shown().processing;
    wanted.plan.maskShiftPx = shiftTool_->shiftPx();
    wanted.isSubtracted = true;
    change(wanted, [] { return tr("Pixel shift"); });
}

void SubtractionController::updateFromDocument()
{
    const core::Case& current = document_.current();
    treatedRuns_.retainOnly(core::storedRunOf(current.shown()));
    if (view_.tool() == shiftTool_ && current.shown().processing.plan.maskShiftPx && !idleTimer_.isActive() &&
        !request_) {
        initialShift_ = *current.shown().processing.plan.maskShiftPx;   // undo may have changed the shift
        shiftTool_->showShift(initialShift_);
    }
    showState();
}

void SubtractionController::showState()
{
    const core::Case& current = document_.current();
    ui::RunState state;
    state.processing = current.shown().processing;
    state.polarity = current.shown().angiogram ? current.shown().angiogram->polarity : core::Polarity::VesselsDark;
    state.maskFrames = current.shown().processing.plan.maskFrames.empty() ? sync_.suggestedMasks()
                                                                          : current.shown().processing.plan.maskFrames;
    state.hasRun = current.shown().angiogram && current.shown().angiogram->frameCount() > 1;
    state.isComputing = isComputing();
    panel_.showRun(state);
    strip_.showMasks(state.hasRun && !current.shown().processing.plan.interval ? state.maskFrames : std::vector<int>(),
                     current.shown().processing.isSubtracted);
    actions_[ui::Command::Subtract]->setChecked(request_ ? request_->processing.isSubtracted
                                                         : current.shown().processing.isSubtracted);
    actions_[ui::Command::Composite]->setChecked(request_ ? request_->processing.isComposite
                                                          : current.shown().processing.isComposite);
    for (const ui::Command command :
         {ui::Command::Subtract, ui::Command::Composite, ui::Command::ShiftMask, ui::Command::SetMaskFrame}) {
        actions_[command]->setEnabled(state.hasRun);
    }
}

}   // namespace angiopose::app
