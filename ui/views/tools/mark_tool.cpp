#include "ui/views/tools/mark_tool.h"

#include "ui/views/angiogram_view.h"
#include "ui/views/paint_marks.h"
#include "ui/words/retranslation.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr double markReachPx = 9.0;
constexpr int textEditWidth = 220;
constexpr int maxLetters = 200;

}   // namespace

MarkTool::MarkTool(MarkMode mode, AngiogramView& view) : ImageTool(view), mode_(mode) {}

void MarkTool::showHandles(std::vector<Eigen::Vector2d> handles)
{
    if (handles != handles_) {
        handles_ = std::move(handles);
        draggedHandle_.reset();
        if (view().tool() == this) {
            view().redraw();
        }
    }
}

QString MarkTool::caption() const
{
    switch (mode_) {
        case MarkMode::TargetPoint:
            return tr("Target point: click the vessels, here, in 3-D or in a slice · points can be moved");
        case MarkMode::OstiumRing:
            return tr("Ostium ring: click the vessels, here, in 3-D or in a slice · rings can be moved");
        case MarkMode::TargetInImage:
            return tr("Mark in image: click where the selected target point appears, or drag it there");
        case MarkMode::Arrow:
            return tr("Arrow: drag from tail to tip, then type a label · ends can be moved");
        case MarkMode::Text:
            break;
    }
    return tr("Text: click where the text should start, then type · text can be moved");
}

std::optional<std::size_t> MarkTool::handleAt(const QPointF& position) const
{
    std::optional<std::size_t> nearest;
    double nearestPx = markReachPx;
    for (std::size_t i = 0; i < handles_.size(); ++i) {
        const QPointF offset = view().widgetFromImage(handles_[i]) - position;
        if (std::hypot(offset.x(), offset.y()) < nearestPx) {
            nearestPx = std::hypot(offset.x(), offset.y());
            nearest = i;
        }
    }
    return nearest;
}

std::optional<Eigen::Vector2d> MarkTool::snapped(const Eigen::Vector2d& pixel) const
{
    return snap_ ? snap_(pixel) : std::optional(pixel);
}

bool MarkTool::startDrag(const ToolPoint& pressed)
{
    finishTextEdit();
    draggedHandle_ = handleAt(pressed.position);
    points_.clear();
    if (!draggedHandle_ && mode_ == MarkMode::Arrow) {
        points_ = {pressed.imagePx};
    }
    return true;   // accepts every drag, so that window/level does not change during marking
}

void MarkTool::drag(const ToolPoint& point)
{
    mousePx_ = point.imagePx;
    view().redraw();
}

void MarkTool::finishDrag(const ToolPoint& point)
{
    if (const auto held = std::exchange(draggedHandle_, std::nullopt)) {
        emit handleMoved(static_cast<int>(*held), point.imagePx);
    } else if (!points_.empty()) {
        points_.push_back(point.imagePx);
        startTextEdit();
    } else {
        click(point);   // a press with slight movement counts as a click
    }
    view().redraw();
}

bool MarkTool::click(const ToolPoint& point)
{
    finishTextEdit();
    if (mode_ == MarkMode::Text) {
        points_ = {point.imagePx};
        startTextEdit();
    } else if (mode_ != MarkMode::Arrow) {
        emit placed(point.imagePx);
    }
    return true;
}

/// Opens a line edit at the first point; Enter or any other action commits the text, Esc discards it.
void MarkTool::startTextEdit()
{
    textEdit_ = new QLineEdit(&view());
    withAccessibleName(textEdit_, [] { return tr("Text on the image"); });
    textEdit_->setMaxLength(maxLetters);
    textEdit_->setPlaceholderText(tr("Text, then Enter"));
    const QPointF at = view().widgetFromImage(points_.front());
    const QSize size(std::min(textEditWidth, view().width()), textEdit_->sizeHint().height());
    textEdit_->setGeometry(std::clamp(qRound(at.x()) + 8, 0, view().width() - size.width()),
                           std::clamp(qRound(at.y()) + 8, 0, std::max(0, view().height() - size.height())),
                           size.width(), size.height());
    connect(textEdit_, &QLineEdit::editingFinished, this, &MarkTool::finishTextEdit);
    textEdit_->show();
    textEdit_->setFocus();
}

void MarkTool::finishTextEdit()
{
    QLineEdit* line = std::exchange(textEdit_, nullptr);
    if (!line) {
        return;
    }
    const QString words = line->text().simplified();
    line->hide();
    line->deleteLater();
    view().setFocus();
    const std::vector<Eigen::Vector2d> points = std::exchange(points_, {});
    if (!words.isEmpty() || points.size() == 2) {
        emit written(points, words);
    }
    view().redraw();
}

void MarkTool::hover(const ToolPoint& point)
{
    mousePx_ = point.imagePx;
    view().redraw();
}

void MarkTool::leave()
{
    mousePx_.reset();
    view().redraw();
}

bool MarkTool::takesKey(const QKeyEvent& event) const
{
    return event.key() == Qt::Key_Delete && (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier && !textEdit_;
}

void MarkTool::keyPress(const QKeyEvent&)
{
    emit removeRequested();
}

bool MarkTool::undoStep()
{
    const bool hadWords = textEdit_ != nullptr;
    drop();
    return hadWords;
}

void MarkTool::drop()
{
    draggedHandle_.reset();
    points_.clear();
    if (QLineEdit* line = std::exchange(textEdit_, nullptr)) {
        line->hide();
        line->deleteLater();
        view().setFocus();
    }
    view().redraw();
}

std::optional<QCursor> MarkTool::cursor(bool isDragging) const
{
    return QCursor(isDragging && draggedHandle_ ? Qt::ClosedHandCursor : Qt::CrossCursor);
}

void MarkTool::paint(QPainter& painter) const
{
    const auto positionOf = [this](const Eigen::Vector2d& pixel) -> Eigen::Vector2d {
        const QPointF place = view().widgetFromImage(pixel);
        return {place.x(), place.y()};
    };
    painter.save();
    for (std::size_t i = 0; i < handles_.size(); ++i) {
        const bool isHeld = draggedHandle_ == i;
        paintHandle(painter, positionOf(isHeld && mousePx_ ? *mousePx_ : handles_[i]), isHeld);
    }
    if (!points_.empty() && (points_.size() == 2 || mousePx_) && mode_ == MarkMode::Arrow) {
        paintMarks(painter,
                   {{MarkShape::Arrow, {points_.front(), points_.size() == 2 ? points_[1] : *mousePx_}, {}, true}},
                   positionOf);
    } else if (mousePx_ && snap_ && !draggedHandle_) {
        if (const auto place = snapped(*mousePx_)) {
            paintMarks(painter, {{MarkShape::Point, {*place}, {}, true}}, positionOf);
        }
    }
    painter.restore();
}

}   // namespace angiopose::ui
