#include "ui/views/tools/pivot_tool.h"

#include "core/vessel/tree_position.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double pivotReachPx = 12.0;   // maximum distance of a click from the vessels, widget px
constexpr double nodeReachPx = 8.0;   // widget px; clicks within this distance snap to a bifurcation or end

}   // namespace

void PivotTool::showTree(const core::VesselTree& tree)
{
    tree_ = tree;
    nodes_.clear();
    for (const core::VesselNode& node : core::findNodes(tree)) {
        nodes_.push_back(node.pointInPatient);
    }
    candidate_.reset();
    node_ = 0;
}

QString PivotTool::caption() const
{
    return tr("Rotation center: click the vessels, here or in 3-D · ← → and Enter: bifurcations · Del: centroid");
}

const Color& PivotTool::tone() const
{
    return palette(ThemeMode::Dark).attention;
}

void PivotTool::end()
{
    candidate_.reset();
}

std::optional<Eigen::Vector3d> PivotTool::pointAt(const ToolPoint& point) const
{
    const Eigen::Vector3d* nearest = nullptr;
    double nearestPx = nodeReachPx;
    for (const Eigen::Vector3d& node : nodes_) {
        if (const auto nodePosition = view().positionOf(node)) {
            const QPointF offset = *nodePosition - point.position;
            if (std::hypot(offset.x(), offset.y()) < nearestPx) {
                nearestPx = std::hypot(offset.x(), offset.y());
                nearest = &node;
            }
        }
    }
    if (nearest) {
        return *nearest;
    }
    if (core::findProblem(view().camera())) {
        return std::nullopt;
    }
    return core::pointUnderPixel(tree_, {view().camera(), view().cameraFromPatient()}, point.imagePx,
                                 pivotReachPx / view().zoom());
}

bool PivotTool::click(const ToolPoint& point)
{
    if (const auto nodePosition = pointAt(point)) {
        emit picked(*nodePosition);
    }
    return true;   // accepts clicks next to the vessels, which have no effect
}

void PivotTool::hover(const ToolPoint& point)
{
    candidate_ = pointAt(point);
    view().redraw();
}

void PivotTool::leave()
{
    candidate_.reset();
}

bool PivotTool::takesKey(const QKeyEvent& event) const
{
    switch (event.key()) {
        case Qt::Key_Left:
        case Qt::Key_Right:
            return !nodes_.empty();
        case Qt::Key_Return:
        case Qt::Key_Enter:
            return candidate_.has_value();
        case Qt::Key_Delete:
            return true;
        default:
            return false;
    }
}

void PivotTool::keyPress(const QKeyEvent& event)
{
    switch (event.key()) {
        case Qt::Key_Left:
            step(-1);
            break;
        case Qt::Key_Right:
            step(1);
            break;
        case Qt::Key_Delete:
            emit centroidRequested();
            break;
        default:
            emit picked(*candidate_);
    }
}

/// Moves the candidate to the next or previous node; the first key press selects the first or last node.
void PivotTool::step(int by)
{
    const std::size_t count = nodes_.size();
    const bool isFirst = !candidate_ || *candidate_ != nodes_[node_];
    node_ = isFirst ? (by > 0 ? 0 : count - 1) : (by > 0 ? node_ + 1 : node_ + count - 1) % count;
    candidate_ = nodes_[node_];
    view().redraw();
}

std::optional<QCursor> PivotTool::cursor(bool) const
{
    return QCursor(candidate_ ? Qt::PointingHandCursor : Qt::CrossCursor);
}

void PivotTool::paint(QPainter& painter) const
{
    const auto nodePosition = candidate_ ? view().positionOf(*candidate_) : std::nullopt;
    if (nodePosition) {
        painter.setPen(QPen(toQColor(tone()), 1.6, Qt::DotLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(*nodePosition, 9.0, 9.0);
    }
}

}   // namespace angiopose::ui
