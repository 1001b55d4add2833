#include "app/showing/cine_controller.h"

#include "app/preferences/settings.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"

#include <algorithm>
#include <cmath>

namespace angiopose::app {
namespace {

constexpr double usualFrameMs = 1000.0 / 15.0;   ///< used if the file states no frame rate
constexpr double nsPerMs = 1e6;

double frameMsOf(const core::Angiogram& run)
{
    return run.frameTimeMs > 1.0 ? run.frameTimeMs : usualFrameMs;
}

}   // namespace

CineController::CineController(CaseDocument& document, ViewSync& sync, ReviewController& review,
                               ui::WindowActions& actions, ui::BottomStrip& strip, QObject* parent)
    : QObject(parent),
      document_(document),
      sync_(sync),
      review_(review),
      actions_(actions),
      strip_(strip),
      speed_(settings::playSpeed.read()),
      order_(settings::playBackAndForth.read() ? core::CineOrder::BackAndForth : core::CineOrder::Loop)
{
    elapsed_.start();
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &CineController::showDueFrame);
    connect(&document_, &CaseDocument::changed, this, &CineController::updateFromDocument);
    connect(&strip_.play(), &ui::PlayBar::playClicked, actions_[ui::Command::Cine], &QAction::trigger);
    connect(&strip_.play(), &ui::PlayBar::speedPicked, this, &CineController::chooseSpeed);
    connect(&strip_.play(), &ui::PlayBar::orderPicked, this, &CineController::chooseOrder);
    connect(&strip_, &ui::BottomStrip::loopMarked, this, &CineController::chooseLoop);
    connectCommands();
    chooseSpeed(speed_);
    chooseOrder(order_);
    updateFromDocument();
}

void CineController::connectCommands()
{
    const auto on = [this](ui::Command command, auto act) {
        connect(actions_[command], &QAction::triggered, this, act);
    };
    connect(actions_[ui::Command::Cine], &QAction::toggled, this, &CineController::setPlaying);
    on(ui::Command::Cine, [this](bool plays) {
        if (!plays) {
            adoptFrame();
        }
    });
    on(ui::Command::PlaySlower, [this] { changeSpeed(-1); });
    on(ui::Command::PlayFaster, [this] { changeSpeed(1); });
    on(ui::Command::PlayBackAndForth,
       [this](bool turns) { chooseOrder(turns ? core::CineOrder::BackAndForth : core::CineOrder::Loop); });
    on(ui::Command::SetLoopStart, [this] {
        chooseLoop({sync_.shownFrame(), std::max(loop_.last, sync_.shownFrame())});
    });
    on(ui::Command::SetLoopEnd, [this] {
        chooseLoop({std::min(loop_.first, sync_.shownFrame()), sync_.shownFrame()});
    });
    on(ui::Command::ClearLoop, [this] { chooseLoop({0, frameCount() - 1}); });
}

int CineController::frameCount() const
{
    const auto& angiogram = document_.current().shown().angiogram;
    return angiogram ? angiogram->frameCount() : 0;
}

void CineController::updateFromDocument()
{
    const auto run = core::storedRunOf(document_.current().shown());
    if (run == run_ && loop_.last < std::max(1, frameCount())) {
        return;
    }
    run_ = run;
    actions_[ui::Command::Cine]->setChecked(false);
    for (const ui::Command command :
         {ui::Command::Cine, ui::Command::SetLoopStart, ui::Command::SetLoopEnd, ui::Command::ClearLoop}) {
        actions_[command]->setEnabled(frameCount() > 1);
    }
    chooseLoop({0, std::max(0, frameCount() - 1)});
    if (run_) {
        strip_.play().showFrameTime({frameMsOf(*run_), run_->frameTimeMs <= 1.0});
    }
}

void CineController::setPlaying(bool on)
{
    if (on && frameCount() > 1) {
        restart();
    } else {
        timer_.stop();
        stoppedFrame_ = clock_ ? std::optional(sync_.shownFrame()) : std::nullopt;
        clock_.reset();
        sync_.showFrame(document_.current().shown().frame);
        if (on) {
            actions_[ui::Command::Cine]->setChecked(false);
        }
    }
    strip_.play().showPlaying(clock_.has_value());
}

/// Makes the frame on screen that of the case after the user has stopped playback.
void CineController::adoptFrame()
{
    if (const auto frame = std::exchange(stoppedFrame_, std::nullopt); frame && !document_.isLocked()) {
        review_.showFrame(*frame);
    }
}

/// Restarts playback at the frame on screen with the current settings.
void CineController::restart()
{
    const double nowMs = static_cast<double>(elapsed_.nsecsElapsed()) / nsPerMs;
    clock_.emplace(loop_, order_, frameMsOf(*document_.current().shown().angiogram) / speed_);
    clock_->start(sync_.shownFrame(), nowMs);
    showDueFrame();
}

void CineController::showDueFrame()
{
    const double nowMs = static_cast<double>(elapsed_.nsecsElapsed()) / nsPerMs;
    const int due = std::min(clock_->frameAt(nowMs), frameCount() - 1);
    if (due != sync_.shownFrame()) {
        sync_.showFrame(due);
    }
    const double doneMs = static_cast<double>(elapsed_.nsecsElapsed()) / nsPerMs;
    timer_.start(static_cast<int>(std::ceil(clock_->msUntilNextFrame(doneMs))));
}

void CineController::chooseSpeed(double speed)
{
    const bool isOffered = std::ranges::find(ui::playSpeeds, speed) != ui::playSpeeds.end();
    speed_ = isOffered ? speed : 1.0;
    settings::playSpeed.write(speed_);
    strip_.play().showSpeed(speed_);
    if (clock_) {
        restart();
    }
}

void CineController::changeSpeed(int step)
{
    const auto now = std::ranges::find(ui::playSpeeds, speed_) - ui::playSpeeds.begin();
    const auto last = static_cast<std::ptrdiff_t>(ui::playSpeeds.size()) - 1;
    const auto next = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(now + step, 0, last));
    chooseSpeed(ui::playSpeeds.at(next));
}

void CineController::chooseOrder(core::CineOrder order)
{
    order_ = order;
    settings::playBackAndForth.write(order == core::CineOrder::BackAndForth);
    actions_[ui::Command::PlayBackAndForth]->setChecked(order == core::CineOrder::BackAndForth);
    strip_.play().showOrder(order);
    if (clock_) {
        restart();
    }
}

void CineController::chooseLoop(const core::FrameRange& range)
{
    loop_ = range;
    strip_.showLoop(range);
    if (clock_) {
        restart();
    }
}

}   // namespace angiopose::app
