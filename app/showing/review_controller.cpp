#include "app/showing/review_controller.h"

#include "app/document/edit_case.h"
#include "app/preferences/apply_settings.h"
#include "app/preferences/settings.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

#include <QDateTime>

#include <algorithm>
#include <array>
#include <climits>

namespace angiopose::app {
namespace {

using namespace std::chrono_literals;

constexpr int frameBursts = 1 << 20;   ///< offset that separates the merge IDs of frames from those of poses
constexpr qint64 reviewBurstPauseMs = 1500;

}   // namespace

ReviewController::ReviewController(CaseDocument& document, ViewSync& sync, PosePreview& preview, const Ui& ui,
                                   QObject* parent)
    : QObject(parent), document_(document), sync_(sync), preview_(preview), ui_(ui)
{
    connectMotion();
    connectWindow();
    connectShape();
}

void ReviewController::connectShape()
{
    QAction* deformed = ui_.actions[ui::Command::DeformedVessels];
    deformed->setChecked(preview_.shape() == VesselShape::Deformed);
    connect(deformed, &QAction::toggled, this, [this](bool on) {
        preview_.setShape(on ? VesselShape::Deformed : VesselShape::Rigid);
        showShapeNote(on ? tr("Vessels: deformed") : tr("Vessels: rigid pose"));
    });
    connect(ui_.actions[ui::Command::DeformationColors], &QAction::toggled, this, [this](bool on) {
        preview_.setMotionColored(on);
        showShapeNote(on ? tr("Colors: displacement of the deformed vessels")
                         : tr("Colors: distance to the traced vessels"));
    });
}

void ReviewController::showShapeNote(const QString& note)
{
    const core::Case& current = document_.current();
    const bool isKnown = deformationForPose(current.shown(), current.vessels, preview_.pose()) != nullptr;
    ui_.strip.showStatus(isKnown ? note : tr("There are no deformed vessels for this pose"));
}

void ReviewController::connectMotion()
{
    ui::WindowActions& actions = ui_.actions;
    flickerTimer_.setInterval(600ms);
    connect(&flickerTimer_, &QTimer::timeout, this, &ReviewController::toggleFlickerPose);
    connect(actions[ui::Command::Flicker], &QAction::toggled, this, &ReviewController::setFlickering);
    const std::array motions{ui::Command::Flicker, ui::Command::Cine, ui::Command::Replay, ui::Command::Swing};
    for (const ui::Command motion : motions) {
        connect(actions[motion], &QAction::triggered, this, [&actions, motion, motions](bool on) {
            for (const ui::Command other : motions) {
                if (on && other != motion) {
                    actions[other]->setChecked(false);   // at most one animation at a time
                }
            }
        });
    }
    QAction* reduce = actions[ui::Command::ReduceMotion];
    reduce->setChecked(settings::reduceMotion.read());
    connect(reduce, &QAction::toggled, this, [](bool on) { settings::reduceMotion.write(on); });
}

void ReviewController::connectWindow()
{
    ui::WindowActions& actions = ui_.actions;
    connect(&ui_.view, &ui::AngiogramView::frameStepRequested, this, &ReviewController::stepFrame);
    connect(&ui_.strip, &ui::BottomStrip::frameRequested, this, &ReviewController::showFrame);
    connect(actions[ui::Command::ResetTreeView], &QAction::triggered, &ui_.treeView, &ui::TreeView::nextView);
    const std::array themes{std::pair{ui::Command::ThemeDark, "dark"}, std::pair{ui::Command::ThemeLight, "light"},
                            std::pair{ui::Command::ThemeSystem, "system"}};
    for (const auto& [command, name] : themes) {
        const QString stored = QString::fromLatin1(name);
        actions[command]->setChecked(settings::theme.read() == stored);
        connect(actions[command], &QAction::triggered, this, [this, stored] { applyTheme(stored); });
    }
    ui_.treeView.setTheme(ui::activeTheme());
}

void ReviewController::stepFrame(int step)
{
    const auto& angiogram = document_.current().shown().angiogram;
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
    ui_.actions[ui::Command::Cine]->setChecked(false);
    if (frame == document_.current().shown().frame) {
        sync_.showFrame(frame);
        return;
    }
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (now - lastFrameChangeMs_ > reviewBurstPauseMs) {
        ++frameMergeId_;
    }
    lastFrameChangeMs_ = now;
    const core::View turned = core::withFrame(document_.current().shown(), frame);
    document_.push(std::make_unique<ShowFrame>(
        document_, ShowFrame::Values{frame, turned.initialCameraFromPatient, turned.cameraFromPatient, turned.result},
        [] { return tr("Choose another frame"); }, frameBursts + frameMergeId_));
}

void ReviewController::setFlickering(bool on)
{
    if (!on) {
        flickerTimer_.stop();
        showsInitialPose_ = false;
        preview_.end(PreviewSource::Start);
        return;
    }
    toggleFlickerPose();
    if (!settings::reduceMotion.read()) {
        flickerTimer_.start();   // with reduced motion, each press of F toggles once instead
    }
}

void ReviewController::toggleFlickerPose()
{
    const auto start = core::initialPoseOf(document_.current());
    if (!start || document_.isLocked()) {
        stopMotion();
        return;
    }
    showsInitialPose_ = !showsInitialPose_;
    if (showsInitialPose_) {
        preview_.show(PreviewSource::Start, start.value(), ResidualColors::Hidden);
    } else {
        preview_.end(PreviewSource::Start);
    }
    ui_.strip.showStatus(showsInitialPose_ ? tr("Before: initial pose") : tr("After: current pose"));
}

void ReviewController::stopMotion()
{
    for (const ui::Command motion :
         {ui::Command::Flicker, ui::Command::Cine, ui::Command::Replay, ui::Command::Swing}) {
        ui_.actions[motion]->setChecked(false);
    }
}

void ReviewController::applyTheme(const QString& name)
{
    settings::theme.write(name);
    applyThemeSetting(*qApp);
    ui_.treeView.setTheme(ui::activeTheme());
}

}   // namespace angiopose::app
