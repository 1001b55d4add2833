#include "ui/views/tools/lasso_tool.h"

#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"

#include <QPainter>

#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr double minStepPx = 2.0;   // minimum distance between vertices, widget px
constexpr int minVertices = 3;

LassoEffect effectOf(Qt::KeyboardModifiers modifiers)
{
    return modifiers.testFlag(Qt::ShiftModifier)     ? LassoEffect::Adds
           : modifiers.testFlag(Qt::ControlModifier) ? LassoEffect::Removes
                                                     : LassoEffect::Replaces;
}

QPointF toPoint(const Eigen::Vector2d& imagePx)
{
    return {imagePx.x(), imagePx.y()};
}

}   // namespace

QString LassoTool::caption() const
{
    return tr("Lasso: draw around the auxiliary branches · Shift adds · Ctrl removes · Esc ends");
}

bool LassoTool::startDrag(const ToolPoint& pressed)
{
    outline_.clear();
    outline_ << toPoint(pressed.imagePx);
    return true;
}

void LassoTool::drag(const ToolPoint& point)
{
    const QPointF corner = toPoint(point.imagePx);
    const QPointF step = corner - outline_.back();
    if (view().zoom() * std::hypot(step.x(), step.y()) >= minStepPx) {
        outline_ << corner;
        view().redraw();
    }
}

void LassoTool::finishDrag(const ToolPoint& point)
{
    const QPolygonF outline = std::exchange(outline_, {});
    view().redraw();
    if (outline.size() >= minVertices) {
        emit outlineDrawn(outline, effectOf(point.modifiers));
    }
}

void LassoTool::cancelDrag()
{
    outline_.clear();
    view().redraw();
}

std::optional<QCursor> LassoTool::cursor(bool) const
{
    return QCursor(Qt::CrossCursor);
}

void LassoTool::paint(QPainter& painter) const
{
    if (outline_.size() < 2) {
        return;
    }
    QPolygonF shown;
    for (const QPointF& corner : outline_) {
        shown << view().widgetFromImage({corner.x(), corner.y()});
    }
    const Color& accent = palette(ThemeMode::Dark).accent;   // images have a dark background in every theme
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(toQColor(accent), 1.5, Qt::DashLine));
    painter.setBrush(toQColor(accent, 0.12));
    painter.drawPolygon(shown);
}

}   // namespace angiopose::ui
