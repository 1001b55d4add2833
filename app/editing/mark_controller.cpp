#include "app/editing/mark_controller.h"

#include "app/document/edit_case.h"
#include "app/words/mark_words.h"
#include "core/messages/messages.h"
#include "core/vessel/tree_position.h"
#include "ui/actions/window_actions.h"
#include "ui/slices/slice_model.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/bind_tool.h"
#include "ui/views/tree_view.h"
#include "ui/words/message_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace angiopose::app {
namespace {

using core::ImageAnnotation;
using core::TargetObservation;
using core::VesselMark;
using core::VesselMarkKind;
using ui::MarkMode;

constexpr double placeReachPx = 14.0;   // maximum distance of a vessel from the pointer, widget px
constexpr double sliceReachMm = 4.0;   // maximum distance of a click in a slice from the vessels
constexpr double sameMm = 1e-6;

std::size_t positionOf(MarkMode mode)
{
    return static_cast<std::size_t>(mode);
}

bool isOnVessels(MarkMode mode)
{
    return mode == MarkMode::TargetPoint || mode == MarkMode::OstiumRing;
}

VesselMarkKind kindOf(MarkMode mode)
{
    return mode == MarkMode::OstiumRing ? VesselMarkKind::OstiumRing : VesselMarkKind::TargetPoint;
}

/// Places a mark on the nearest branch and gives a ring the diameter of the branch there. Returns nullopt if there is
/// no branch, or no radius for a ring.
std::optional<VesselMark> putOn(const core::VesselTree& tree, VesselMark mark, const Eigen::Vector3d& point)
{
    const auto place = core::nearestPosition(tree, point);
    if (!place) {
        return std::nullopt;
    }
    mark.pointInPatient = core::pointAt(tree, *place);
    if (mark.kind == VesselMarkKind::OstiumRing) {
        const auto radius = core::radiusAt(tree, *place);
        if (!radius) {
            return std::nullopt;
        }
        mark.radiusMm = *radius;
        mark.normal = core::directionAt(tree, *place);
    }
    return mark;
}

}   // namespace

MarkController::MarkController(CaseDocument& document, const ViewSync& sync, const PosePreview& preview, const Ui& ui,
                               QObject* parent)
    : QObject(parent), document_(document), sync_(sync), preview_(preview), ui_(ui)
{
    constexpr std::array commands{ui::Command::TargetPoint, ui::Command::OstiumRing, ui::Command::TargetInImage,
                                  ui::Command::DrawArrow, ui::Command::WriteText};
    for (std::size_t mode = 0; mode < ui::markModeCount; ++mode) {
        connectMode(static_cast<MarkMode>(mode), *ui_.actions[commands[mode]]);
    }
    connectPanel();
    updateTimer_.setSingleShot(true);
    updateTimer_.setInterval(0);
    connect(&updateTimer_, &QTimer::timeout, this, &MarkController::show);
    connect(&document_, &CaseDocument::changed, this, &MarkController::show);
    connect(&preview_, &PosePreview::changed, &updateTimer_, qOverload<>(&QTimer::start));
    connect(&sync_, &ViewSync::frameShown, this, &MarkController::show);
    ui::keepTranslated(this, [this] { show(); });
}

void MarkController::connectMode(MarkMode mode, QAction& action)
{
    auto* tool = new ui::MarkTool(mode, ui_.view);
    tools_[positionOf(mode)] = tool;
    ui::bindTool(action, ui_.view, *tool);
    ui_.panel.bindMode(positionOf(mode), action);
    if (isOnVessels(mode)) {
        tool->setSnap([this](const Eigen::Vector2d& pixel) -> std::optional<Eigen::Vector2d> {
            const auto place = vesselPointAt(pixel);
            const auto at = place ? ui_.view.positionOf(*place) : std::nullopt;
            return at ? std::optional(ui_.view.imageFromWidget(*at)) : std::nullopt;
        });
    }
    connect(&action, &QAction::toggled, this, [this, mode, &action](bool on) {
        if (on && !(isOnVessels(mode) ? current().vessels.tree != nullptr : current().shown().angiogram != nullptr)) {
            action.setChecked(false);
            emit refused(isOnVessels(mode) ? tr("Open the vessels first.") : tr("Open an angiogram first."));
        }
    });
    connect(tool, &ui::MarkTool::placed, this, [this, mode](const Eigen::Vector2d& pixel) { place(mode, pixel); });
    connect(tool, &ui::MarkTool::written, this, &MarkController::addText);
    connect(tool, &ui::MarkTool::handleMoved, this, [this, mode](int handle, const Eigen::Vector2d& pixel) {
        moveHandle(mode, static_cast<std::size_t>(handle), pixel);
    });
    connect(tool, &ui::MarkTool::removeRequested, this, &MarkController::removeSelectedOrLast);
}

void MarkController::connectPanel()
{
    const ui::MarkPanel& panel = ui_.panel;
    connect(&panel, &ui::MarkPanel::selectionChanged, this, &MarkController::show);
    connect(&panel, &ui::MarkPanel::renamed, this,
            [this](int row, const QString& name) { rename(static_cast<std::size_t>(row), name); });
    connect(&panel, &ui::MarkPanel::removeRequested, this, &MarkController::remove);
    connect(&panel, &ui::MarkPanel::exportRequested, ui_.actions[ui::Command::ExportTargetPoints], &QAction::trigger);
}

core::PoseOfView MarkController::poseOf() const
{
    return [this](std::size_t view) { return preview_.poseOfView(view); };
}

/// Returns the point on the drawn vessels under the pixel.
std::optional<Eigen::Vector3d> MarkController::vesselPointAt(const Eigen::Vector2d& pixel) const
{
    if (core::findProblem(ui_.view.camera())) {
        return std::nullopt;
    }
    return core::pointUnderPixel(ui_.view.scene().content().tree, {ui_.view.camera(), ui_.view.cameraFromPatient()},
                                 pixel, placeReachPx / ui_.view.zoom());
}

/// Maps a point on the deformed vessels back to the rigid ones, where marks are stored.
Eigen::Vector3d MarkController::toRigidPoint(const Eigen::Vector3d& drawnPoint) const
{
    const core::Vessels& vessels = current().vessels;
    const DrawnVessels drawn = vesselsToDraw(current().shown(), vessels, preview_.pose(), preview_.shape());
    VesselMark mark;
    mark.pointInPatient = drawnPoint;
    return drawn.shape == VesselShape::Deformed ? core::moveWithVessels(drawn.tree, *vessels.tree, mark).pointInPatient
                                                : drawnPoint;
}

void MarkController::pickPoint(const Eigen::Vector3d& pointInPatient)
{
    const bool isPoint = ui_.actions[ui::Command::TargetPoint]->isChecked();
    if (!isPoint && !ui_.actions[ui::Command::OstiumRing]->isChecked()) {
        return;
    }
    const auto& tree = current().vessels.tree;
    const auto drawn = core::nearestPointOnTree(ui_.view.scene().content().tree, pointInPatient);
    const bool isOfDrawn = drawn && (*drawn - pointInPatient).norm() < sameMm;   // the point was picked in the 3-D view
    const Eigen::Vector3d point = isOfDrawn ? toRigidPoint(pointInPatient) : pointInPatient;
    const auto nearest = tree ? core::nearestPosition(*tree, point) : std::nullopt;
    const double reachMm = nearest ? std::max(sliceReachMm, core::radiusAt(*tree, *nearest).value_or(0.0)) : 0.0;
    if (!nearest || (core::pointAt(*tree, *nearest) - point).norm() > reachMm) {
        emit refused(ui::messageText(core::messages::markNeedsVessels()));
        return;
    }
    add(isPoint ? VesselMarkKind::TargetPoint : VesselMarkKind::OstiumRing, point);
}

void MarkController::place(MarkMode mode, const Eigen::Vector2d& pixel)
{
    if (mode == MarkMode::TargetInImage) {
        addObservation(pixel, selectedTargetPoint(pixel));
        return;
    }
    const auto point = vesselPointAt(pixel);
    if (!point) {
        emit refused(ui::messageText(core::messages::markNeedsVessels()));
        return;
    }
    add(kindOf(mode), toRigidPoint(*point));
}

void MarkController::add(VesselMarkKind kind, const Eigen::Vector3d& pointInPatient)
{
    VesselMark mark;
    mark.id = core::nextMarkId(marks());
    mark.kind = kind;
    mark.name = unusedMarkName(kind, marks()).toStdString();
    const auto put = putOn(*current().vessels.tree, std::move(mark), pointInPatient);
    if (!put) {
        emit refused(ui::messageText(core::messages::ringNeedsRadius()));
        return;
    }
    std::vector<VesselMark> all = marks();
    all.push_back(*put);
    const auto row = static_cast<int>(all.size()) - 1;
    changeMarks(std::move(all), [kind] {
        return kind == VesselMarkKind::TargetPoint ? tr("Add target point") : tr("Add ostium ring");
    });
    if (row < static_cast<int>(marks().size())) {
        ui_.panel.choose(row);
    }
}

/// Returns the target point that is selected in the list, otherwise the only one, otherwise the one drawn nearest.
std::optional<int> MarkController::selectedTargetPoint(const Eigen::Vector2d& pixel) const
{
    const auto isPoint = [this](std::size_t i) { return marks()[i].kind == VesselMarkKind::TargetPoint; };
    for (const int row : ui_.panel.selectedRows()) {
        if (static_cast<std::size_t>(row) < marks().size() && isPoint(static_cast<std::size_t>(row))) {
            return marks()[static_cast<std::size_t>(row)].id;
        }
    }
    std::optional<int> nearest;
    double nearestPx = std::numeric_limits<double>::infinity();
    const QPointF at = ui_.view.widgetFromImage(pixel);
    for (std::size_t i = 0; i < marks().size(); ++i) {
        const auto place = isPoint(i) ? ui_.view.positionOf(marks()[i].pointInPatient) : std::nullopt;
        const double away = place ? std::hypot(place->x() - at.x(), place->y() - at.y()) : nearestPx;
        if (away < nearestPx) {
            nearestPx = away;
            nearest = marks()[i].id;
        }
    }
    return nearest;
}

void MarkController::addObservation(const Eigen::Vector2d& pixel, std::optional<int> markId)
{
    if (!markId) {
        emit refused(tr("Add a target point on the vessels first."));
        return;
    }
    std::vector<TargetObservation> all = current().shown().observations;
    const int frame = sync_.shownFrame();
    const auto isSame = [&](const TargetObservation& observation) {
        return observation.markId == *markId && observation.frame == frame;
    };
    const auto known = std::ranges::find_if(all, isSame);
    if (known != all.end()) {
        known->pixel = pixel;
    } else {
        all.push_back({*markId, pixel, frame});
    }
    document_.push(std::make_unique<ChangeObservations>(document_, ChangeObservations::Values{std::move(all)},
                                                        [] { return tr("Mark target point in image"); }));
    show();
}

void MarkController::addText(const std::vector<Eigen::Vector2d>& pixels, const QString& words)
{
    const bool isArrow = pixels.size() == 2;
    std::vector<ImageAnnotation> all = current().shown().annotations;
    all.push_back({isArrow ? core::AnnotationKind::Arrow : core::AnnotationKind::Text, pixels, words.toStdString(),
                   sync_.shownFrame()});
    changeAnnotations(std::move(all), [isArrow] { return isArrow ? tr("Draw arrow") : tr("Add text"); });
}

void MarkController::moveHandle(MarkMode mode, std::size_t handle, const Eigen::Vector2d& pixel)
{
    const Handle held = handles_[positionOf(mode)].at(handle);
    if (mode == MarkMode::TargetInImage) {
        addObservation(pixel, marks().at(held.index).id);
        return;
    }
    if (!isOnVessels(mode)) {
        std::vector<ImageAnnotation> all = current().shown().annotations;
        all.at(held.index).pixels.at(held.point) = pixel;
        changeAnnotations(std::move(all), [] { return tr("Move mark"); });
        return;
    }
    const auto point = vesselPointAt(pixel);
    const auto moved =
        point ? putOn(*current().vessels.tree, marks().at(held.index), toRigidPoint(*point)) : std::nullopt;
    if (!moved) {
        emit refused(ui::messageText(core::messages::markNeedsVessels()));
        show();
        return;
    }
    std::vector<VesselMark> all = marks();
    all.at(held.index) = *moved;
    changeMarks(std::move(all), [] { return tr("Move mark"); });
}

void MarkController::rename(std::size_t row, const QString& name)
{
    const std::string words = name.simplified().toStdString();
    const ui::LocalizedText edit = [] { return tr("Rename mark"); };
    const std::size_t count = marks().size();
    if (row < count && words != marks()[row].name) {
        std::vector<VesselMark> all = marks();
        all[row].name = words;
        changeMarks(std::move(all), edit);
    } else if (row >= count && row - count < current().shown().annotations.size() &&
               words != current().shown().annotations[row - count].text) {
        std::vector<ImageAnnotation> all = current().shown().annotations;
        all[row - count].text = words;
        changeAnnotations(std::move(all), edit);
    } else {
        show();   // restores the displayed name if only surrounding whitespace changed
    }
}

/// Removes marks, including their image positions in all views, and annotations of the displayed view in one undo step.
void MarkController::remove(const std::set<int>& rows)
{
    std::vector<VesselMark> kept;
    std::set<int> gone;
    for (std::size_t i = 0; i < marks().size(); ++i) {
        if (rows.contains(static_cast<int>(i))) {
            gone.insert(marks()[i].id);
        } else {
            kept.push_back(marks()[i]);
        }
    }
    std::vector<core::View> views = current().views;
    for (core::View& view : views) {
        std::erase_if(view.observations,
                      [&gone](const TargetObservation& observation) { return gone.contains(observation.markId); });
    }
    std::vector<ImageAnnotation>& annotations = views[current().shownView].annotations;
    const std::size_t before = annotations.size();
    auto row = static_cast<int>(marks().size());
    std::erase_if(annotations, [&](const ImageAnnotation&) { return rows.contains(row++); });
    if (!gone.empty() || annotations.size() != before) {
        document_.push(std::make_unique<RemoveMarks>(document_, RemoveMarks::Values{std::move(kept), std::move(views)},
                                                     [] { return tr("Remove mark"); }));
    }
    show();
}

void MarkController::removeSelectedOrLast()
{
    const std::set<int> selectedRows = ui_.panel.selectedRows();
    const std::size_t count = marks().size() + current().shown().annotations.size();
    remove(selectedRows.empty() ? std::set<int>{static_cast<int>(count) - 1} : selectedRows);
}

void MarkController::changeMarks(std::vector<VesselMark> marks, const ui::LocalizedText& name)
{
    document_.push(std::make_unique<ChangeMarks>(document_, ChangeMarks::Values{std::move(marks)}, name));
    show();   // needed even if the edit was refused
}

void MarkController::changeAnnotations(std::vector<ImageAnnotation> annotations, const ui::LocalizedText& name)
{
    document_.push(
        std::make_unique<ChangeAnnotations>(document_, ChangeAnnotations::Values{std::move(annotations)}, name));
    show();
}

}   // namespace angiopose::app
