#include "app/review/replay_controller.h"

#include "ui/actions/key_hint.h"

#include "app/document/edit_case.h"
#include "app/preferences/settings.h"
#include "core/registration/pose/centroid_pose.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/words/number.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace angiopose::app {
namespace {

using namespace std::chrono_literals;

constexpr int phasesPerSwing = 60;
constexpr double swingSigmas = 2.0;

/// Returns the RMS distance of the tree's points from their centroid, mm, i.e. the displacement per rad of rotation.
double spreadMm(const core::VesselTree& tree, const Eigen::Vector3d& centroid)
{
    double sum = 0.0;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            sum += (point - centroid).squaredNorm();
        }
    }
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, tree.pointCount())));
}

QString nameOfAxis(Eigen::Index axis)
{
    static const std::array names{QT_TRANSLATE_NOOP("angiopose::app::ReplayController", "tilt"),
                                  QT_TRANSLATE_NOOP("angiopose::app::ReplayController", "turn"),
                                  QT_TRANSLATE_NOOP("angiopose::app::ReplayController", "roll"),
                                  QT_TRANSLATE_NOOP("angiopose::app::ReplayController", "horizontal"),
                                  QT_TRANSLATE_NOOP("angiopose::app::ReplayController", "vertical"),
                                  QT_TRANSLATE_NOOP("angiopose::app::ReplayController", "depth")};
    return ReplayController::tr(names[static_cast<std::size_t>(axis)]);
}

}   // namespace

ReplayController::ReplayController(CaseDocument& document, PosePreview& preview, ui::WindowActions& actions,
                                   ui::BottomStrip& strip, QObject* parent)
    : QObject(parent), document_(document), preview_(preview), actions_(actions), strip_(strip)
{
    replayTimer_.setInterval(80ms);
    swingTimer_.setInterval(40ms);
    connect(&replayTimer_, &QTimer::timeout, this, &ReplayController::showStep);
    connect(&swingTimer_, &QTimer::timeout, this, &ReplayController::showSwing);
    connect(actions[ui::Command::Replay], &QAction::toggled, this, &ReplayController::setReplaying);
    connect(actions[ui::Command::Swing], &QAction::toggled, this, &ReplayController::setSwinging);
    connect(actions[ui::Command::NextSolution], &QAction::triggered, this, &ReplayController::showNextSolution);
    connect(actions[ui::Command::AcceptSolution], &QAction::triggered, this, &ReplayController::acceptSolution);
    connect(&document_, &CaseDocument::changed, this, [this, &actions] {
        actions[ui::Command::Replay]->setChecked(false);
        actions[ui::Command::Swing]->setChecked(false);
        showCurrentPose();
    });
    connect(&preview_, &PosePreview::replaced, this, [this](PreviewSource whose) {
        if (whose == PreviewSource::Solution) {
            showCurrentPose();
        }
    });
}

void ReplayController::showCurrentPose()
{
    if (std::exchange(solution_, 0) != 0) {
        preview_.end(PreviewSource::Solution);
        emit solutionChanged(0);
    }
}

void ReplayController::setReplaying(bool on)
{
    if (!on) {
        replayTimer_.stop();
        preview_.end(PreviewSource::Replay);
        return;
    }
    if (!document_.current().shown().result || document_.current().shown().result->history.empty() ||
        document_.isLocked()) {
        actions_[ui::Command::Replay]->setChecked(false);
        strip_.showStatus(tr("There is no registration to replay. Register first (R)."));
        return;
    }
    step_ = 0;
    showStep();
    replayTimer_.start();
}

void ReplayController::showStep()
{
    const auto& result = document_.current().shown().result;
    if (!result || step_ >= result->history.size()) {
        actions_[ui::Command::Replay]->setChecked(false);
        strip_.showStatus(tr("Replay ended"));
        return;
    }
    const core::IterationReport& report = result->history[step_++];
    preview_.show(PreviewSource::Replay, report.cameraFromPatient, ResidualColors::Hidden);
    strip_.showStatus(tr("Replay: step %1 of %2, %3 px")
                          .arg(step_)
                          .arg(result->history.size())
                          .arg(ui::numberText(report.medianDistancePx, 2)));
}

std::optional<ReplayController::Swing> ReplayController::swing() const
{
    const core::Case& current = document_.current();
    if (!uncertainty_ || !current.vessels.tree || uncertainty_->weakestDirection.norm() < 0.5) {
        return std::nullopt;
    }
    core::Vector6d perMm = core::Vector6d::Ones();   // factors from (rad, mm) to mm at the tree
    perMm.head<3>().setConstant(spreadMm(*current.vessels.tree, core::centroidInPatient(*current.vessels.tree)));
    const core::Vector6d& direction = uncertainty_->weakestDirection;
    const core::Vector6d scaled = perMm.cwiseProduct(direction);
    Swing swing;
    const bool isKnown =
        uncertainty_->imageCovariance.diagonal().maxCoeff() > 0.0;   // zero in results of earlier versions
    const core::Matrix6d& byImage = isKnown ? uncertainty_->imageCovariance : uncertainty_->covariance;
    swing.sigmaMm = std::sqrt(std::max(0.0, scaled.dot(byImage * scaled)));
    swing.perSigma = swing.sigmaMm * direction.cwiseQuotient(perMm);
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    swing.statusText = nameOfAxis(axis);
    return swing;
}

void ReplayController::setSwinging(bool on)
{
    if (!on) {
        swingTimer_.stop();
        preview_.end(PreviewSource::Swing);
        return;
    }
    if (!swing() || document_.isLocked()) {
        actions_[ui::Command::Swing]->setChecked(false);
        strip_.showStatus(tr("The uncertainty of this pose is not known yet."));
        return;
    }
    phase_ = settings::reduceMotion.read() ? phasesPerSwing / 4 : 0;   // with reduced motion, one end of the swing
    showSwing();
    if (!settings::reduceMotion.read()) {
        swingTimer_.start();
    }
}

void ReplayController::showSwing()
{
    const auto weakest = swing();
    if (!weakest) {
        actions_[ui::Command::Swing]->setChecked(false);
        return;
    }
    const double sigmas = swingSigmas * std::sin(2.0 * std::numbers::pi * phase_++ / phasesPerSwing);
    const Eigen::Vector3d centroid = core::centroidInPatient(*document_.current().vessels.tree);
    const core::CentroidPose pose = core::aboutCentroid(document_.current().shown().cameraFromPatient, centroid);
    preview_.show(PreviewSource::Swing,
                  core::cameraFromPatient(core::retract(pose, sigmas * weakest->perSigma), centroid),
                  ResidualColors::Hidden);
    strip_.showStatus(tr("Because of image noise alone, poses within ±%1 mm (2 σ, mainly %2) cannot be distinguished")
                          .arg(ui::numberText(swingSigmas * weakest->sigmaMm, 1))
                          .arg(weakest->statusText));
}

void ReplayController::showNextSolution()
{
    const auto& result = document_.current().shown().result;
    if (!result || result->alternatives.empty() || document_.isLocked()) {
        strip_.showStatus(result ? tr("The registration found no other solution.")
                                 : tr("There is no registration yet. Register first (R)."));
        return;
    }
    showSolution(solution_ < result->alternatives.size() ? solution_ + 1 : 0);
}

void ReplayController::showSolution(std::size_t index)
{
    const auto& result = document_.current().shown().result;
    if (!result || index > result->alternatives.size() || document_.isLocked()) {
        return;
    }
    emit solutionShown();
    if (index == 0) {
        showCurrentPose();
        strip_.showStatus(tr("Registered solution"));
        return;
    }
    solution_ = index;
    const core::Hypothesis& other = result->alternatives[index - 1];
    preview_.show(PreviewSource::Solution, other.cameraFromPatient, ResidualColors::Hidden);
    const QString takes = ui::keyOf(ui::Command::AcceptSolution);
    strip_.showStatus(result->wirePaths.empty() ? tr("Alternative solution %1 of %2, score %3 · %4 to accept")
                                                      .arg(index)
                                                      .arg(result->alternatives.size())
                                                      .arg(ui::numberText(other.score, 2))
                                                      .arg(takes)
                                                : tr("Alternative path %1 of %2, probability %3 % · %4 to accept")
                                                      .arg(index)
                                                      .arg(result->alternatives.size())
                                                      .arg(ui::numberText(100.0 * other.score, 0))
                                                      .arg(takes));
    emit solutionChanged(index);
}

void ReplayController::acceptSolution()
{
    const auto& result = document_.current().shown().result;
    if (solution_ == 0 || !result || solution_ > result->alternatives.size()) {
        strip_.showStatus(tr("Show the other solutions first (J)."));
        return;
    }
    const core::RigidTransform pose = result->alternatives[solution_ - 1].cameraFromPatient;
    document_.push(
        std::make_unique<MovePose>(document_, MovePose::Values{pose, std::nullopt, {}},
                                   [number = solution_ + 1] { return tr("Accept solution %1").arg(number); }));
}

}   // namespace angiopose::app
