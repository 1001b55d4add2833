#include "app/review_controller.h"

#include "app/commands/edit_case.h"
#include "app/settings.h"
#include "app/theme_choice.h"
#include "ui/main_window.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

#include <QDateTime>

#include <algorithm>
#include <climits>

namespace app {
namespace {

using namespace std::chrono_literals;

constexpr double opacityStep = 0.1;
constexpr double usualFrameMs = 1000.0 / 15.0;   ///< where the run does not say
constexpr int frameBursts = 1 << 20;   ///< keeps burst numbers of frames apart from those of poses
constexpr qint64 burstPauseMs = 1500;

}   // namespace

ReviewController::ReviewController(CaseDocument& document, ViewSync& sync, ui::MainWindow& window, QObject* parent)
    : QObject(parent), document_(document), sync_(sync), window_(window)
{
    connectOverlay();
    connectMotion();
    connectWindow();
}

void ReviewController::connectOverlay()
{
    ui::WindowActions& actions = window_.actions();
    ui::AngiogramView& view = window_.angiogramView();
    connect(actions[ui::Command::Fit], &QAction::triggered, &view, &ui::AngiogramView::fitToWindow);
    connect(actions[ui::Command::AutoWindow], &QAction::triggered, &view, &ui::AngiogramView::autoWindowLevel);
    connect(actions[ui::Command::Outline], &QAction::toggled, this, &ReviewController::updateOverlayMode);
    connect(&window_, &ui::MainWindow::hideKeyHeld, this, [this](bool held) {
        overlayHeldHidden_ = held;
        updateOverlayMode();
    });
    connect(actions[ui::Command::Invert], &QAction::toggled, &view, [&view](bool on) {
        view.scene().setInverted(on);
        view.update();
    });
    connect(actions[ui::Command::ShowTrace], &QAction::toggled, &view, [&view](bool on) {
        view.scene().showTracedCenterline(on);
        view.update();
    });
    connect(actions[ui::Command::MoreOpacity], &QAction::triggered, this, [this] { changeOpacity(opacityStep); });
    connect(actions[ui::Command::LessOpacity], &QAction::triggered, this, [this] { changeOpacity(-opacityStep); });
    view.scene().setOpacity(settings::overlayOpacity.read());

    QAction* identity = actions[ui::Command::HideIdentity];
    connect(identity, &QAction::toggled, this, [this](bool hidden) {
        settings::identityHidden.write(hidden);
        sync_.setIdentityHidden(hidden);
    });
    identity->setChecked(settings::identityHidden.read());
}

void ReviewController::connectMotion()
{
    ui::WindowActions& actions = window_.actions();
    flickerTimer_.setInterval(600ms);
    connect(&flickerTimer_, &QTimer::timeout, this, &ReviewController::flick);
    connect(actions[ui::Command::Flicker], &QAction::toggled, this, &ReviewController::setFlickering);
    connect(&cineTimer_, &QTimer::timeout, this, [this] {
        const int count = document_.current().angiogram ? document_.current().angiogram->frameCount() : 0;
        if (count > 1) {
            sync_.showFrame((sync_.shownFrame() + 1) % count);
        }
    });
    connect(actions[ui::Command::Cine], &QAction::toggled, this, &ReviewController::setPlaying);
    QAction* reduce = actions[ui::Command::ReduceMotion];
    reduce->setChecked(settings::reduceMotion.read());
    connect(reduce, &QAction::toggled, this, [](bool on) { settings::reduceMotion.write(on); });
}

void ReviewController::connectWindow()
{
    ui::WindowActions& actions = window_.actions();
    connect(&window_.angiogramView(), &ui::AngiogramView::frameStepRequested, this, &ReviewController::stepFrame);
    connect(&window_.strip(), &ui::BottomStrip::frameRequested, this, &ReviewController::showFrame);
    connect(actions[ui::Command::ResetTreeView], &QAction::triggered, &window_.treeView(), &ui::TreeView::resetView);
    connect(actions[ui::Command::FullScreen], &QAction::toggled, this,
            [this](bool on) { window_.setWindowState(window_.windowState().setFlag(Qt::WindowFullScreen, on)); });
    const std::array themes{std::pair{ui::Command::ThemeDark, "dark"}, std::pair{ui::Command::ThemeLight, "light"},
                            std::pair{ui::Command::ThemeSystem, "system"}};
    for (const auto& [command, name] : themes) {
        const QString stored = QString::fromLatin1(name);
        actions[command]->setChecked(settings::theme.read() == stored);
        connect(actions[command], &QAction::triggered, this, [this, stored] { applyTheme(stored); });
    }
    window_.treeView().setTheme(ui::activeTheme());
}

void ReviewController::updateOverlayMode()
{
    const bool outline = window_.actions()[ui::Command::Outline]->isChecked();
    const auto shown = outline ? ui::OverlayMode::Outline : ui::OverlayMode::Centerline;
    window_.angiogramView().scene().setMode(overlayHeldHidden_ ? ui::OverlayMode::Hidden : shown);
    window_.angiogramView().update();
}

void ReviewController::stepFrame(int step)
{
    const auto& angiogram = document_.current().angiogram;
    if (!angiogram) {
        return;
    }
    const int last = angiogram->frameCount() - 1;
    if (step == INT_MIN || step == INT_MAX) {
        showFrame(step == INT_MIN ? 0 : last);
    } else {
        showFrame(std::clamp(sync_.shownFrame() + step, 0, last));
    }
}

void ReviewController::showFrame(int frame)
{
    window_.actions()[ui::Command::Cine]->setChecked(false);
    if (frame == document_.current().frame) {
        sync_.showFrame(frame);
        return;
    }
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (now - lastFrameMs_ > burstPauseMs) {
        ++frameBurst_;
    }
    lastFrameMs_ = now;
    document_.push(std::make_unique<ShowFrame>(document_, ShowFrame::Values{frame}, tr("Choose another frame"),
                                               frameBursts + frameBurst_));
}

void ReviewController::setFlickering(bool on)
{
    if (!on) {
        flickerTimer_.stop();
        showsStart_ = false;
        sync_.endPreview();
        return;
    }
    flick();
    if (!settings::reduceMotion.read()) {
        flickerTimer_.start();   // otherwise each press of F switches once
    }
}

void ReviewController::flick()
{
    const auto start = core::startPoseOf(document_.current());
    if (!start || document_.isLocked()) {
        stopMotion();
        return;
    }
    showsStart_ = !showsStart_;
    if (showsStart_) {
        sync_.showPreview(start.value());
    } else {
        sync_.endPreview();
    }
    window_.strip().showStatus(showsStart_ ? tr("Before: start pose") : tr("After: pose as it is"));
}

void ReviewController::setPlaying(bool on)
{
    const auto& angiogram = document_.current().angiogram;
    if (on && angiogram && angiogram->frameCount() > 1) {
        const double frameMs = angiogram->frameTimeMs > 1.0 ? angiogram->frameTimeMs : usualFrameMs;
        cineTimer_.start(static_cast<int>(frameMs));
        return;
    }
    cineTimer_.stop();
    sync_.showFrame(document_.current().frame);
    if (on) {
        window_.actions()[ui::Command::Cine]->setChecked(false);
    }
}

void ReviewController::stopMotion()
{
    window_.actions()[ui::Command::Flicker]->setChecked(false);
    window_.actions()[ui::Command::Cine]->setChecked(false);
}

void ReviewController::changeOpacity(double by)
{
    const double opacity = std::clamp(settings::overlayOpacity.read() + by, opacityStep, 1.0);
    settings::overlayOpacity.write(opacity);
    window_.angiogramView().scene().setOpacity(opacity);
    window_.angiogramView().update();
    window_.strip().showStatus(tr("Overlay opacity %1 %").arg(100.0 * opacity, 0, 'f', 0));
}

void ReviewController::applyTheme(const QString& name)
{
    settings::theme.write(name);
    applyChosenTheme(*qApp);
    window_.treeView().setTheme(ui::activeTheme());
}

}   // namespace app
