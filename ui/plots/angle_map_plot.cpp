#include "ui/plots/angle_map_plot.h"

#include "ui/theme/active_theme.h"
#include "ui/words/retranslation.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr int angleLabelHeight = 20;
constexpr int angleLabelWidth = 58;
constexpr double hiddenCost = 1.0;   // foreshortening plus overlap at the upper end of the color ramp
constexpr double primaryTickDeg = 30.0;
constexpr double secondaryTickDeg = 20.0;

QImage imageOf(const core::AngleMap& map)
{
    const auto columns = static_cast<int>(map.primaryDeg.size());
    const auto rows = static_cast<int>(map.secondaryDeg.size());
    QImage image(columns, rows, QImage::Format_RGB32);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            const auto row = static_cast<std::size_t>(rows - 1 - y);   // flipped: cranial is at the top
            const double cost = map.at(static_cast<std::size_t>(x), row).cost();
            image.setPixelColor(x, y, toQColor(residualColor(std::min(1.0, cost / hiddenCost))));
        }
    }
    return image;
}

QString tickText(double deg, const char* negative, const char* positive)
{
    const QString number = QString::number(std::abs(deg), 'f', 0);
    return deg == 0.0 ? number : QLatin1String(deg < 0.0 ? negative : positive) + QLatin1Char(' ') + number;
}

/// Returns a color that contrasts with the map in every theme.
QColor markTone()
{
    return toQColor(palette(ThemeMode::Dark).textStrong);
}

void drawOutlined(QPainter& painter, const QPointF& pos, const QString& text, const Palette& colors)
{
    painter.setPen(toQColor(colors.canvas));
    for (const QPointF& offset : {QPointF(-1, 0), QPointF(1, 0), QPointF(0, -1), QPointF(0, 1)}) {
        painter.drawText(pos + offset, text);
    }
    painter.setPen(markTone());
    painter.drawText(pos, text);
}

}   // namespace

AngleMapPlot::AngleMapPlot(QWidget* parent) : QWidget(parent)
{
    setMinimumSize(360, 190);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    withAccessibleName(this, [] { return tr("Gantry angle map"); });
}

void AngleMapPlot::showMap(const std::optional<core::AngleMap>& map)
{
    map_ = map;
    update();
}

void AngleMapPlot::showCurrent(const std::optional<core::GantryAngles>& angles)
{
    current_ = angles;
    update();
}

void AngleMapPlot::showPicked(const core::GantryAngles& angles)
{
    picked_ = angles;
    update();
}

QRectF AngleMapPlot::area() const
{
    return QRectF(rect()).adjusted(angleLabelWidth, 8, -30, -angleLabelHeight);
}

QPointF AngleMapPlot::positionOf(const core::GantryAngles& angles) const
{
    const QRectF map = area();
    const auto fraction = [](const std::vector<double>& grid, double deg) {
        const double width = grid.back() - grid.front();
        return width > 0.0 ? (deg - grid.front()) / width : 0.5;
    };
    return {map.left() + fraction(map_->primaryDeg, angles.primaryDeg) * map.width(),
            map.bottom() - fraction(map_->secondaryDeg, angles.secondaryDeg) * map.height()};
}

core::GantryAngles AngleMapPlot::anglesAt(const QPointF& pos) const
{
    const QRectF map = area();
    const auto deg = [](const std::vector<double>& grid, double fraction) {
        return grid.front() + std::clamp(fraction, 0.0, 1.0) * (grid.back() - grid.front());
    };
    return {std::round(deg(map_->primaryDeg, (pos.x() - map.left()) / map.width())),
            std::round(deg(map_->secondaryDeg, (map.bottom() - pos.y()) / map.height()))};
}

void AngleMapPlot::paintEvent(QPaintEvent*)
{
    const Palette& colors = activePalette();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!map_) {
        painter.fillRect(area(), toQColor(colors.field));
        painter.setPen(toQColor(colors.hint));
        painter.drawText(area(), Qt::AlignCenter, tr("no map yet"));
        return;
    }
    painter.drawImage(area(), imageOf(*map_));
    paintAxes(painter);
    paintMarks(painter);
}

void AngleMapPlot::paintAxes(QPainter& painter) const
{
    const QRectF map = area();
    painter.setPen(toQColor(activePalette().hint));
    const auto ticks = [](const std::vector<double>& grid, double step, const auto& draw) {
        for (double deg = std::ceil(grid.front() / step) * step; deg <= grid.back() + 1e-9; deg += step) {
            draw(deg + 0.0);
        }
    };
    ticks(map_->primaryDeg, primaryTickDeg, [&](double deg) {
        const double x = positionOf({deg, map_->secondaryDeg.front()}).x();
        painter.drawText(QRectF(x - 40, map.bottom() + 3, 80, angleLabelHeight - 3), Qt::AlignHCenter | Qt::AlignTop,
                         tickText(deg, "RAO", "LAO"));
    });
    ticks(map_->secondaryDeg, secondaryTickDeg, [&](double deg) {
        const double pos = positionOf({map_->primaryDeg.front(), deg}).y();
        const double y = std::clamp(pos, map.top() + 6.0, map.bottom() - 6.0);   // avoids the label of the other axis
        painter.drawText(QRectF(0, y - 10, angleLabelWidth - 8, 20), Qt::AlignRight | Qt::AlignVCenter,
                         tickText(deg, "CAU", "CRA"));
    });
}

void AngleMapPlot::paintMarks(QPainter& painter) const
{
    const Palette& colors = activePalette();
    painter.setClipRect(area().adjusted(-4, -4, 4, 4));
    for (std::size_t i = 0; i < map_->best.size(); ++i) {
        const QPointF at = positionOf(map_->best[i].angles);
        const QString number = QString::number(i + 1);
        const double below = at.y() < area().top() + 20 ? 18.0 : -6.0;   // keeps the label inside the map
        const double beside = at.x() > area().right() - 20 ? -16.0 : 6.0;
        painter.setPen(QPen(toQColor(colors.canvas), 3.0));
        painter.drawPoint(at);
        drawOutlined(painter, at + QPointF(beside, below), number, colors);
    }
    if (current_) {
        painter.setPen(QPen(toQColor(colors.canvas), 3.5));
        painter.drawEllipse(positionOf(*current_), 6, 6);
        painter.setPen(QPen(markTone(), 1.5));
        painter.drawEllipse(positionOf(*current_), 6, 6);
    }
    const QPointF at = positionOf(picked_);
    for (const auto& [color, width] : {std::pair{toQColor(colors.canvas), 4.0}, std::pair{markTone(), 1.5}}) {
        painter.setPen(QPen(color, width));
        painter.drawLine(at - QPointF(9, 0), at + QPointF(9, 0));
        painter.drawLine(at - QPointF(0, 9), at + QPointF(0, 9));
    }
}

void AngleMapPlot::mousePressEvent(QMouseEvent* event)
{
    if (map_ && event->button() == Qt::LeftButton) {
        emit picked(anglesAt(event->position()));
    }
}

void AngleMapPlot::mouseMoveEvent(QMouseEvent* event)
{
    if (map_ && event->buttons().testFlag(Qt::LeftButton)) {
        emit picked(anglesAt(event->position()));
    }
}

void AngleMapPlot::keyPressEvent(QKeyEvent* event)
{
    const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 10.0 : 1.0;
    core::GantryAngles next = picked_;
    switch (event->key()) {
        case Qt::Key_Left:
            next.primaryDeg -= step;
            break;
        case Qt::Key_Right:
            next.primaryDeg += step;
            break;
        case Qt::Key_Up:
            next.secondaryDeg += step;
            break;
        case Qt::Key_Down:
            next.secondaryDeg -= step;
            break;
        default:
            QWidget::keyPressEvent(event);
            return;
    }
    if (map_) {
        next.primaryDeg = std::clamp(next.primaryDeg, map_->primaryDeg.front(), map_->primaryDeg.back());
        next.secondaryDeg = std::clamp(next.secondaryDeg, map_->secondaryDeg.front(), map_->secondaryDeg.back());
        emit picked(next);
    }
}

}   // namespace angiopose::ui
