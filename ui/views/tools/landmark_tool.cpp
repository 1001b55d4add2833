#include "ui/views/tools/landmark_tool.h"

#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr double landmarkReachPx = 10.0;
constexpr double armPx = 7.0;
constexpr double ringPx = 5.0;

double distance(const QPointF& a, const QPointF& b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

const Palette& landmarkTones()
{
    return palette(ThemeMode::Dark);   // images have a dark background in every theme
}

}   // namespace

void LandmarkTool::showMarks(const LandmarkMarks& marks)
{
    marks_ = marks;
    view().redraw();
}

QString LandmarkTool::caption() const
{
    if (marks_.pendingPointInPatient) {
        return tr("Landmarks: now click the same point in the image");
    }
    if (marks_.pendingPixel) {
        return tr("Landmarks: now click the same point on the vessels in 3-D");
    }
    return tr("Landmarks: click in 3-D and here, or drag a node · Enter computes the pose");
}

std::optional<LandmarkTool::DraggedItem> LandmarkTool::draggableAt(const QPointF& position) const
{
    std::optional<DraggedItem> nearest;
    double nearestPx = landmarkReachPx;
    for (std::size_t i = 0; i < marks_.pairs.size(); ++i) {
        const double away = distance(view().widgetFromImage(marks_.pairs[i].pixel), position);
        if (away < nearestPx) {
            nearestPx = away;
            nearest = DraggedItem{static_cast<int>(i), marks_.pairs[i].pointInPatient, marks_.pairs[i].pixel};
        }
    }
    if (nearest) {
        return nearest;
    }
    for (const Eigen::Vector3d& node : marks_.nodesInPatient) {
        const auto place = view().positionOf(node);
        if (place && distance(*place, position) < nearestPx) {
            nearestPx = distance(*place, position);
            nearest = DraggedItem{std::nullopt, node, view().imageFromWidget(*place)};
        }
    }
    return nearest;
}

bool LandmarkTool::startDrag(const ToolPoint& pressed)
{
    dragged_ = draggableAt(pressed.position);
    return true;   // accepts every drag, so that window/level does not change next to landmarks
}

void LandmarkTool::drag(const ToolPoint& point)
{
    if (dragged_) {
        dragged_->pixel = point.imagePx;
        view().redraw();
    }
}

void LandmarkTool::finishDrag(const ToolPoint& point)
{
    const auto dragged = std::exchange(dragged_, std::nullopt);
    if (dragged && dragged->index) {
        emit pairMoved(*dragged->index, point.imagePx);
    } else if (dragged) {
        emit pairDrawn(dragged->nodeInPatient, point.imagePx);
    }
}

void LandmarkTool::cancelDrag()
{
    dragged_.reset();
    view().redraw();
}

bool LandmarkTool::click(const ToolPoint& point)
{
    emit pixelPicked(point.imagePx);
    return true;
}

bool LandmarkTool::takesKey(const QKeyEvent& event) const
{
    const bool isPlain = (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    return isPlain && (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter || event.key() == Qt::Key_Delete);
}

void LandmarkTool::keyPress(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_Delete) {
        emit removeLastRequested();
    } else {
        emit poseRequested();
    }
}

bool LandmarkTool::undoStep()
{
    const bool hasHalf = marks_.pendingPointInPatient || marks_.pendingPixel;
    if (hasHalf) {
        emit cancelRequested();
    }
    return hasHalf;
}

void LandmarkTool::end()
{
    dragged_.reset();
    emit cancelRequested();
}

std::optional<QCursor> LandmarkTool::cursor(bool isDragging) const
{
    return QCursor(isDragging && dragged_ ? Qt::ClosedHandCursor : Qt::CrossCursor);
}

void LandmarkTool::paintPair(QPainter& painter, const QString& label, const std::optional<Eigen::Vector2d>& pixel,
                             const std::optional<Eigen::Vector3d>& pointInPatient) const
{
    const auto place = pixel ? std::optional(view().widgetFromImage(*pixel)) : std::nullopt;
    const auto shadow = pointInPatient ? view().positionOf(*pointInPatient) : std::nullopt;
    if (place && shadow) {
        painter.setPen(QPen(toQColor(landmarkTones().attention), 1.2, Qt::DotLine));
        painter.drawLine(*place, *shadow);
    }
    if (shadow) {
        painter.setPen(QPen(toQColor(landmarkTones().attention), 1.6));
        painter.drawEllipse(*shadow, ringPx, ringPx);
    }
    if (place) {
        painter.setPen(QPen(toQColor(landmarkTones().accent), 1.8));
        painter.drawLine(*place - QPointF(armPx, 0.0), *place + QPointF(armPx, 0.0));
        painter.drawLine(*place - QPointF(0.0, armPx), *place + QPointF(0.0, armPx));
    }
    painter.setPen(toQColor(landmarkTones().textStrong));
    painter.drawText(place.value_or(shadow.value_or(QPointF())) + QPointF(armPx, -armPx), label);
}

void LandmarkTool::paint(QPainter& painter) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < marks_.pairs.size(); ++i) {
        const bool isHeld = dragged_ && dragged_->index == static_cast<int>(i);
        paintPair(painter, QString::number(i + 1), isHeld ? dragged_->pixel : marks_.pairs[i].pixel,
                  marks_.pairs[i].pointInPatient);
    }
    const QString next = QString::number(marks_.pairs.size() + 1);
    if (dragged_ && !dragged_->index) {
        paintPair(painter, next, dragged_->pixel, dragged_->nodeInPatient);
    } else if (marks_.pendingPixel || marks_.pendingPointInPatient) {
        paintPair(painter, next, marks_.pendingPixel, marks_.pendingPointInPatient);
    }
    painter.setPen(QPen(toQColor(landmarkTones().textStrong), 1.4));
    for (const Eigen::Vector3d& node : marks_.nodesInPatient) {
        if (const auto place = view().positionOf(node)) {
            painter.drawEllipse(*place, 3.5, 3.5);
        }
    }
    painter.restore();
}

}   // namespace angiopose::ui
