#include "app/editing/landmark_controller.h"

#include "app/document/edit_case.h"
#include "core/registration/pose/landmark_pose.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/landmark_panel.h"
#include "ui/slices/slice_model.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/bind_tool.h"
#include "ui/views/tree_view.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace angiopose::app {
namespace {

constexpr double nodeReachMm = 4.0;

const core::VesselNode* nodeNear(const std::vector<core::VesselNode>& nodes, const Eigen::Vector3d& point)
{
    const auto away = [&point](const core::VesselNode& node) { return (node.pointInPatient - point).norm(); };
    const auto nearest = std::ranges::min_element(nodes, {}, away);
    return nearest != nodes.end() && away(*nearest) < nodeReachMm ? &*nearest : nullptr;
}

std::string branchName(const core::VesselTree& tree, int branchId)
{
    const core::VesselBranch* branch = tree.find(branchId);
    return branch && !branch->name.empty() ? branch->name : std::to_string(branchId);
}

/// Describes a position on the tree, e.g. "bifurcation 3 / 5", "end of 3" or "on 3".
QString placeName(const core::VesselTree& tree, const std::vector<core::VesselNode>& nodes,
                  const Eigen::Vector3d& point)
{
    if (const core::VesselNode* node = nodeNear(nodes, point)) {
        QStringList names;
        for (const int id : node->branchIds) {
            names << QString::fromStdString(branchName(tree, id));
        }
        return node->isBifurcation() ? LandmarkController::tr("bifurcation %1").arg(names.join(QStringLiteral(" / ")))
                                     : LandmarkController::tr("end of %1").arg(names.join(QStringLiteral(" / ")));
    }
    double nearest = std::numeric_limits<double>::infinity();
    QString name;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& each : branch.pointsInPatient) {
            if ((each - point).norm() < nearest) {
                nearest = (each - point).norm();
                name = LandmarkController::tr("on %1").arg(QString::fromStdString(branchName(tree, branch.id)));
            }
        }
    }
    return nearest < nodeReachMm ? name : LandmarkController::tr("point outside the vessels");
}

QString verdictOf(const core::LandmarkPose& pose)
{
    if (pose.usesPrior) {
        return LandmarkController::tr(
            "Fewer than four pairs: pose components that the pairs do not determine remain unchanged.");
    }
    return LandmarkController::tr(
               "Residual of the pairs: %1 px. With click errors of 2 px: rotation ±%2°, depth ±%3 mm.")
        .arg(ui::numberText(pose.rmsPx, 1))
        .arg(ui::numberText(pose.rotationStdDeg, 1))
        .arg(ui::numberText(pose.depthStdMm, 0));
}

/// Numbers the points from 1; a point that still lacks an image position comes last.
std::vector<ui::SliceMark> sliceMarksAt(const std::vector<Eigen::Vector3d>& points,
                                        const std::optional<Eigen::Vector3d>& pending)
{
    std::vector<ui::SliceMark> marks;
    marks.reserve(points.size() + 1);
    for (const Eigen::Vector3d& point : points) {
        marks.push_back({point, QString::number(marks.size() + 1)});
    }
    if (pending) {
        marks.push_back({*pending, QString::number(marks.size() + 1)});
    }
    return marks;
}

}   // namespace

LandmarkController::LandmarkController(CaseDocument& document, const Ui& ui, QObject* parent)
    : QObject(parent), document_(document), ui_(ui), tool_(new ui::LandmarkTool(ui_.view))
{
    connectTool();
    ui::LandmarkPanel& panel = ui_.panel;
    panel.bindMode(*ui_.actions[ui::Command::Landmarks]);
    connect(&panel, &ui::LandmarkPanel::poseRequested, this, &LandmarkController::setInitialPose);
    connect(&panel, &ui::LandmarkPanel::removeRequested, this, &LandmarkController::removePairs);
    connect(ui_.actions[ui::Command::RegisterLandmarks], &QAction::triggered, this,
            &LandmarkController::setInitialPose);
    connect(&document_, &CaseDocument::changed, this, &LandmarkController::updateFromDocument);
    ui::keepTranslated(this, [this] { showState(); });
}

void LandmarkController::connectTool()
{
    QAction* action = ui_.actions[ui::Command::Landmarks];
    ui::bindTool(*action, ui_.view, *tool_);
    connect(action, &QAction::toggled, this, &LandmarkController::showState);
    connect(tool_, &ui::LandmarkTool::pixelPicked, this, &LandmarkController::pickPixel);
    connect(tool_, &ui::LandmarkTool::pairDrawn, this, &LandmarkController::addPair);
    connect(tool_, &ui::LandmarkTool::pairMoved, this, [this](int index, const Eigen::Vector2d& pixel) {
        std::vector<core::Landmark> moved = document_.current().shown().landmarks;
        moved[static_cast<std::size_t>(index)].pixel = pixel;
        change(std::move(moved), [index] { return tr("Move landmark %1").arg(index + 1); });
    });
    connect(tool_, &ui::LandmarkTool::removeLastRequested, this,
            [this] { removePairs({static_cast<int>(document_.current().shown().landmarks.size()) - 1}); });
    connect(tool_, &ui::LandmarkTool::cancelRequested, this, &LandmarkController::clearPending);
    connect(tool_, &ui::LandmarkTool::poseRequested, this, &LandmarkController::setInitialPose);
}

void LandmarkController::pickPoint(const Eigen::Vector3d& pointInPatient)
{
    if (!ui_.actions[ui::Command::Landmarks]->isChecked()) {
        return;
    }
    const core::VesselNode* node = nodeNear(nodes_, pointInPatient);
    pendingPoint_ = node ? node->pointInPatient : pointInPatient;
    completePair();
}

void LandmarkController::pickPixel(const Eigen::Vector2d& pixel)
{
    pendingPixel_ = pixel;
    completePair();
}

void LandmarkController::completePair()
{
    if (pendingPoint_ && pendingPixel_) {
        addPair(*std::exchange(pendingPoint_, std::nullopt), *std::exchange(pendingPixel_, std::nullopt));
    }
    showState();
}

void LandmarkController::addPair(const Eigen::Vector3d& pointInPatient, const Eigen::Vector2d& pixel)
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree) {
        emit refused(tr("Open the vessels first."));
        return;
    }
    std::vector<core::Landmark> landmarks = current.shown().landmarks;
    landmarks.push_back(
        {pointInPatient, pixel, placeName(*current.vessels.tree, nodes_, pointInPatient).toStdString()});
    change(std::move(landmarks), [] { return tr("Add landmark"); });
}

void LandmarkController::removePairs(const std::vector<int>& indices)
{
    std::vector<core::Landmark> kept;
    const std::vector<core::Landmark>& all = document_.current().shown().landmarks;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (std::ranges::find(indices, static_cast<int>(i)) == indices.end()) {
            kept.push_back(all[i]);
        }
    }
    if (kept.size() != all.size()) {
        change(std::move(kept), [] { return tr("Remove landmark"); });
    }
}

void LandmarkController::change(std::vector<core::Landmark> landmarks, const ui::LocalizedText& name)
{
    document_.push(std::make_unique<ChangeLandmarks>(document_, ChangeLandmarks::Values{std::move(landmarks)}, name));
}

void LandmarkController::clearPending()
{
    pendingPoint_.reset();
    pendingPixel_.reset();
    showState();
}

std::optional<core::RigidTransform> LandmarkController::initialPoseGuess() const
{
    const core::Case& current = document_.current();
    return core::initialPoseOf(current) ? std::optional(current.shown().cameraFromPatient) : std::nullopt;
}

void LandmarkController::setInitialPose()
{
    const core::Case& current = document_.current();
    const auto camera = core::cameraOf(current.shown());
    if (!camera) {
        emit refused(ui::messageText(camera.error().message));
        return;
    }
    const auto pose = core::poseFromLandmarks(current.shown().landmarks, camera.value(), initialPoseGuess());
    if (!pose) {
        emit refused(ui::messageText(pose.error().message));
        return;
    }
    const core::RigidTransform& found = pose.value().cameraFromPatient;
    const QString verdict = verdictOf(pose.value());
    const bool isDone = document_.push(
        std::make_unique<ChangeInitialPose>(document_, ChangeInitialPose::Values{found, found, std::nullopt, {}},
                                            [] { return tr("Register from landmarks"); }));
    if (isDone) {
        emit placed(verdict);
    }
}

void LandmarkController::updateFromDocument()
{
    if (tree_ != document_.current().vessels.tree) {
        tree_ = document_.current().vessels.tree;
        nodes_ = tree_ ? core::findNodes(*tree_) : std::vector<core::VesselNode>{};
        pendingPoint_.reset();
        pendingPixel_.reset();
    }
    showState();
}

void LandmarkController::showState()
{
    const core::Case& current = document_.current();
    ui::LandmarkMarks marks{current.shown().landmarks, pendingPoint_, pendingPixel_, {}};
    for (const core::VesselNode& node : nodes_) {
        marks.nodesInPatient.push_back(node.pointInPatient);
    }
    tool_->showMarks(marks);

    const bool isOn = ui_.actions[ui::Command::Landmarks]->isChecked();
    std::vector<Eigen::Vector3d> points;
    for (const core::Landmark& landmark : current.shown().landmarks) {
        points.push_back(landmark.pointInPatient);
    }
    ui_.treeView.showLandmarks(isOn ? points : std::vector<Eigen::Vector3d>{}, pendingPoint_);
    ui_.slices.setPoints(ui::SliceMarkKind::Landmark,
                         isOn ? sliceMarksAt(points, pendingPoint_) : std::vector<ui::SliceMark>{});

    ui::LandmarkState state;
    state.landmarks = current.shown().landmarks;
    if (const auto camera = core::cameraOf(current.shown()); camera && !current.shown().landmarks.empty()) {
        state.errorPx =
            core::landmarkErrorsPx(current.shown().landmarks, camera.value(), current.shown().cameraFromPatient);
        const auto pose = core::poseFromLandmarks(current.shown().landmarks, camera.value(), initialPoseGuess());
        state.isEnough = static_cast<bool>(pose);
        state.verdict = pose ? verdictOf(pose.value()) : ui::messageText(pose.error().message);
    }
    ui_.panel.showLandmarks(state);
}

}   // namespace angiopose::app
