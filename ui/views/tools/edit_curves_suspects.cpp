// Curves that may be devices: buttons next to each curve (check mark, wire, cross), and keys that step through these
// curves and classify them.
#include "core/tracing/angiogram/drawing/edit_centerline.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/edit_curves_tool.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double signRadius = 10.0;
constexpr double signGap = 26.0;

const Palette& suspectTones()
{
    return palette(ThemeMode::Dark);
}

/// Returns the icon of a guidewire with a curved tip, centered on the origin.
QPainterPath wireSign()
{
    QPainterPath path(QPointF(-5.0, 3.5));
    path.cubicTo(QPointF(-1.0, 3.5), QPointF(1.0, 1.0), QPointF(1.5, -1.0));
    path.cubicTo(QPointF(2.0, -4.5), QPointF(5.5, -4.5), QPointF(5.5, -1.0));
    return path;
}

}   // namespace

/// Button next to a suspect curve (check mark, wire or cross), in widget px.
struct EditCurvesTool::Sign {
    QPointF center;
    int curveId = 0;
    Decision decision = Decision::Nothing;
};

std::vector<EditCurvesTool::Sign> EditCurvesTool::signs() const
{
    std::vector<Sign> all;
    if (!isReady_ || isDragging_) {
        return all;
    }
    for (const core::Curve2d& curve : curves_.curves) {
        if (std::ranges::find(marks_.suspects, curve.id) != marks_.suspects.end()) {
            const QPointF middle = view().widgetFromImage(curve.pointsPx[curve.pointsPx.size() / 2]);
            all.push_back({middle + QPointF(16.0, -signGap), curve.id, Decision::Vessel});
            all.push_back({middle + QPointF(16.0, 0.0), curve.id, Decision::Device});
            all.push_back({middle + QPointF(16.0, signGap), curve.id, Decision::Nothing});
        }
    }
    return all;
}

bool EditCurvesTool::clickSign(const ToolPoint& point)
{
    const std::vector<Sign> all = signs();
    const auto hit = std::ranges::find_if(all, [&](const Sign& sign) {
        const QPointF offset = point.position - sign.center;
        return std::hypot(offset.x(), offset.y()) <= signRadius + 2.0;
    });
    if (hit == all.end()) {
        return false;
    }
    decide(hit->curveId, hit->decision);
    return true;
}

void EditCurvesTool::decide(int curveId, Decision decision)
{
    switch (decision) {
        case Decision::Vessel:
            emit suspectAccepted(curveId);
            break;
        case Decision::Device:
            markDevice(curveId);
            break;
        case Decision::Nothing:
            report(core::removeCurve(curves_, curveId), [] { return tr("Mark as non-vessel"); });
            break;
    }
}

/// Marks a curve as a device, or removes that mark; does nothing for a negative ID.
void EditCurvesTool::markDevice(int curveId)
{
    if (curveId >= 0) {
        const bool isApart = std::ranges::find(marks_.devices, curveId) != marks_.devices.end();
        emit deviceToggled(curveId, !isApart);
    }
}

/// Selects the next (+1) or previous (−1) suspect curve, cyclically; there must be at least one.
void EditCurvesTool::chooseSuspect(int step)
{
    const auto count = static_cast<std::ptrdiff_t>(marks_.suspects.size());
    const auto at = std::ranges::find(marks_.suspects, chosenSuspect_) - marks_.suspects.begin();
    const auto next = at < count ? (at + step + count) % count : step > 0 ? 0 : count - 1;
    chosenSuspect_ = marks_.suspects[static_cast<std::size_t>(next)];
    view().redraw();
}

bool EditCurvesTool::isSuspectKey(const QKeyEvent& event) const
{
    const bool steps =
        event.key() == Qt::Key_S && (event.modifiers() == Qt::NoModifier || event.modifiers() == Qt::ShiftModifier);
    const bool decides = chosenSuspect_ >= 0 && event.modifiers() == Qt::NoModifier &&
                         (event.key() == Qt::Key_A || event.key() == Qt::Key_W || event.key() == Qt::Key_Delete);
    return isReady_ && !marks_.suspects.empty() && (steps || decides);
}

void EditCurvesTool::suspectKey(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_S) {
        chooseSuspect(event.modifiers() == Qt::ShiftModifier ? -1 : 1);
        return;
    }
    const int classifiedId = chosenSuspect_;
    chooseSuspect(1);   // selects the next curve before the current one is removed
    if (chosenSuspect_ == classifiedId) {
        chosenSuspect_ = -1;
    }
    decide(classifiedId, event.key() == Qt::Key_A   ? Decision::Vessel
                         : event.key() == Qt::Key_W ? Decision::Device
                                                    : Decision::Nothing);
}

void EditCurvesTool::paint(QPainter& painter) const
{
    for (const Sign& sign : signs()) {
        const Color& tone = sign.decision == Decision::Vessel   ? suspectTones().fine
                            : sign.decision == Decision::Device ? suspectTones().textStrong
                                                                : suspectTones().attention;
        painter.setPen(QPen(toQColor(tone), 1.5));
        painter.setBrush(toQColor(suspectTones().field, 0.85));
        const double radius = sign.curveId == chosenSuspect_ ? signRadius + 2.0 : signRadius;
        painter.drawEllipse(sign.center, radius, radius);
        painter.setPen(QPen(toQColor(tone), 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.translate(sign.center);
        switch (sign.decision) {
            case Decision::Vessel:
                painter.drawPolyline(QPolygonF({{-4.5, 0.0}, {-1.0, 3.5}, {4.5, -3.5}}));
                break;
            case Decision::Device:
                painter.drawPath(wireSign());
                break;
            case Decision::Nothing:
                painter.drawLine(QPointF(-3.5, -3.5), QPointF(3.5, 3.5));
                painter.drawLine(QPointF(-3.5, 3.5), QPointF(3.5, -3.5));
                break;
        }
        painter.translate(-sign.center);
    }
}

}   // namespace angiopose::ui
