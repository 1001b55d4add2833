#include "ui/words/pose_axis.h"

#include <QCoreApplication>

#include <array>

namespace angiopose::ui {
namespace {

QString translated(const char* text)
{
    return QCoreApplication::translate("angiopose::ui::PoseAxis", text);
}

double factorOf(Qt::KeyboardModifiers modifiers)
{
    if (modifiers & Qt::ControlModifier) {
        return 0.1;
    }
    return modifiers & Qt::ShiftModifier ? 10.0 : 1.0;
}

std::optional<Nudge> arrowNudge(int key, bool turns)
{
    switch (key) {
        case Qt::Key_Left:
            return Nudge{turns ? PoseAxis::LaoRao : PoseAxis::Right, -1.0};
        case Qt::Key_Right:
            return Nudge{turns ? PoseAxis::LaoRao : PoseAxis::Right, 1.0};
        case Qt::Key_Down:
            return Nudge{turns ? PoseAxis::CraCau : PoseAxis::Up, -1.0};
        case Qt::Key_Up:
            return Nudge{turns ? PoseAxis::CraCau : PoseAxis::Up, 1.0};
        default:
            return std::nullopt;
    }
}

std::optional<Nudge> unitNudge(int key, bool turns)
{
    switch (key) {
        case Qt::Key_PageUp:
            return Nudge{PoseAxis::AlongRay, 1.0};
        case Qt::Key_PageDown:
            return Nudge{PoseAxis::AlongRay, -1.0};
        case Qt::Key_Period:
        case Qt::Key_Greater:
            return Nudge{PoseAxis::Roll, 1.0};
        case Qt::Key_Comma:
        case Qt::Key_Less:
            return Nudge{PoseAxis::Roll, -1.0};
        default:
            return arrowNudge(key, turns);
    }
}

}   // namespace

bool isShift(PoseAxis axis)
{
    return axis == PoseAxis::Right || axis == PoseAxis::Up || axis == PoseAxis::AlongRay;
}

QString labelOf(PoseAxis axis)
{
    static constexpr std::array labels{QT_TRANSLATE_NOOP("angiopose::ui::PoseAxis", "right"),
                                       QT_TRANSLATE_NOOP("angiopose::ui::PoseAxis", "up"),
                                       QT_TRANSLATE_NOOP("angiopose::ui::PoseAxis", "depth"),
                                       QT_TRANSLATE_NOOP("angiopose::ui::PoseAxis", "roll"),
                                       QT_TRANSLATE_NOOP("angiopose::ui::PoseAxis", "LAO / RAO"),
                                       QT_TRANSLATE_NOOP("angiopose::ui::PoseAxis", "CRA / CAU")};
    return translated(labels[static_cast<std::size_t>(axis)]);
}

QString explanationOf(PoseAxis axis)
{
    static constexpr std::array texts{
        QT_TRANSLATE_NOOP("angiopose::ui::PoseAxis", "To the right on screen, in mm at the vessels. Nudge: ← →"),
        QT_TRANSLATE_NOOP("angiopose::ui::PoseAxis", "Up on screen, in mm at the vessels. Nudge: ↑ ↓"),
        QT_TRANSLATE_NOOP("angiopose::ui::PoseAxis", "Away from the X-ray source, in mm. Nudge: PgUp PgDn"),
        QT_TRANSLATE_NOOP("angiopose::ui::PoseAxis", "Clockwise on screen. Nudge: , ."),
        QT_TRANSLATE_NOOP("angiopose::ui::PoseAxis",
                          "Equivalent to rotating the C-arm toward LAO (+) or RAO (−). Nudge: Alt+← Alt+→"),
        QT_TRANSLATE_NOOP("angiopose::ui::PoseAxis",
                          "Equivalent to rotating the C-arm cranially (+) or caudally (−). Nudge: Alt+↑ Alt+↓")};
    return translated(texts[static_cast<std::size_t>(axis)]);
}

core::PoseOffset zeroLocked(core::PoseOffset change, const PoseLocks& locks)
{
    for (const PoseAxis axis : poseAxes) {
        if (core::isLocked(locks, axis)) {
            valueOf(change, axis) = 0.0;
        }
    }
    return change;
}

core::PoseOffset sum(const core::PoseOffset& a, const core::PoseOffset& b)
{
    core::PoseOffset result = a;
    for (const PoseAxis axis : poseAxes) {
        valueOf(result, axis) += valueOf(b, axis);
    }
    return result;
}

std::optional<Nudge> nudgeOfKey(int key, Qt::KeyboardModifiers modifiers)
{
    auto nudge = unitNudge(key, modifiers.testFlag(Qt::AltModifier));
    if (nudge) {
        nudge->amount *= factorOf(modifiers);
    }
    return nudge;
}

}   // namespace angiopose::ui
