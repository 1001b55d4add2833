// Curves that may be catheters: a tick and a cross beside each to click, and keys to go through them and decide.
#include "core/tracing/angiogram/drawing/edit_centerline.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/edit_curves_tool.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double signRadius = 10.0;
constexpr double signGap = 26.0;

const Palette& suspectTones()
{
    return palette(ThemeMode::Dark);
}

}   // namespace

/// A tick or a cross beside a suspect curve, in widget px.
struct EditCurvesTool::Sign {
    QPointF centre;
    int curveId = 0;
    bool accepts = false;
};

std::vector<EditCurvesTool::Sign> EditCurvesTool::signs() const
{
    std::vector<Sign> all;
    if (!isReady_ || isDragging_) {
        return all;
    }
    for (const core::Curve2d& curve : curves_.curves) {
        if (std::ranges::find(suspects_, curve.id) != suspects_.end()) {
            const QPointF middle = view().widgetFromImage(curve.pointsPx[curve.pointsPx.size() / 2]);
            all.push_back({middle + QPointF(16.0, -0.5 * signGap), curve.id, true});
            all.push_back({middle + QPointF(16.0, 0.5 * signGap), curve.id, false});
        }
    }
    return all;
}

bool EditCurvesTool::clickSign(const ToolPoint& point)
{
    const std::vector<Sign> all = signs();
    const auto hit = std::ranges::find_if(all, [&](const Sign& sign) {
        const QPointF way = point.position - sign.centre;
        return std::hypot(way.x(), way.y()) <= signRadius + 2.0;
    });
    if (hit == all.end()) {
        return false;
    }
    decide(hit->curveId, hit->accepts);
    return true;
}

void EditCurvesTool::decide(int curveId, bool isVessel)
{
    if (isVessel) {
        emit suspectAccepted(curveId);
    } else {
        report(core::withoutCurve(curves_, curveId), [] { return tr("Mark as not a vessel"); });
    }
}

/// From one suspect to the next, round and round. There must be one.
void EditCurvesTool::chooseSuspect(int step)
{
    const auto count = static_cast<std::ptrdiff_t>(suspects_.size());
    const auto at = std::ranges::find(suspects_, chosenSuspect_) - suspects_.begin();
    const auto next = at < count ? (at + step + count) % count : step > 0 ? 0 : count - 1;
    chosenSuspect_ = suspects_[static_cast<std::size_t>(next)];
    view().redraw();
}

bool EditCurvesTool::isSuspectKey(const QKeyEvent& event) const
{
    const bool steps =
        event.key() == Qt::Key_S && (event.modifiers() == Qt::NoModifier || event.modifiers() == Qt::ShiftModifier);
    const bool decides = chosenSuspect_ >= 0 && event.modifiers() == Qt::NoModifier &&
                         (event.key() == Qt::Key_A || event.key() == Qt::Key_Delete);
    return isReady_ && !suspects_.empty() && (steps || decides);
}

void EditCurvesTool::suspectKey(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_S) {
        chooseSuspect(event.modifiers() == Qt::ShiftModifier ? -1 : 1);
        return;
    }
    const int decided = chosenSuspect_;
    chooseSuspect(1);   // by its id: the list is another once this one has been decided on
    if (chosenSuspect_ == decided) {
        chosenSuspect_ = -1;
    }
    decide(decided, event.key() == Qt::Key_A);
}

void EditCurvesTool::paint(QPainter& painter) const
{
    for (const Sign& sign : signs()) {
        const Color& tone = sign.accepts ? suspectTones().fine : suspectTones().attention;
        painter.setPen(QPen(toQColor(tone), 1.5));
        painter.setBrush(toQColor(suspectTones().field, 0.85));
        const double radius = sign.curveId == chosenSuspect_ ? signRadius + 2.0 : signRadius;
        painter.drawEllipse(sign.centre, radius, radius);
        painter.setPen(QPen(toQColor(tone), 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const QPointF c = sign.centre;
        if (sign.accepts) {
            const std::array tick{c + QPointF(-4.5, 0.0), c + QPointF(-1.0, 3.5), c + QPointF(4.5, -3.5)};
            painter.drawPolyline(tick.data(), static_cast<int>(tick.size()));
        } else {
            painter.drawLine(c + QPointF(-3.5, -3.5), c + QPointF(3.5, 3.5));
            painter.drawLine(c + QPointF(-3.5, 3.5), c + QPointF(3.5, -3.5));
        }
    }
}

}   // namespace angiopose::ui