#pragma once

#include <Qt>

namespace angiopose::ui {

/// What dragging on the angiogram does when no tool takes the drag.
enum class DragAction { None, WindowLevel, Pan, Zoom, Frames };

/// Habits from other programs: a drag action for each button. Ctrl+left is window and level in all of them.
struct MousePreset {
    DragAction left = DragAction::WindowLevel;
    DragAction shiftLeft = DragAction::WindowLevel;
    DragAction middle = DragAction::Pan;
    DragAction right = DragAction::Zoom;

    DragAction actionOf(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) const
    {
        if (button == Qt::MiddleButton) {
            return middle;
        }
        if (button == Qt::RightButton) {
            return right;
        }
        if (modifiers.testFlag(Qt::ControlModifier)) {
            return DragAction::WindowLevel;
        }
        return modifiers.testFlag(Qt::ShiftModifier) ? shiftLeft : left;
    }
};

/// As in most viewers (Weasis, OHIF): left windows, middle pans, right zooms.
inline constexpr MousePreset radiologyMouse{};
/// As in 3D Slicer: left only picks, Shift+left and middle pan, right zooms.
inline constexpr MousePreset slicerMouse{DragAction::None, DragAction::Pan, DragAction::Pan, DragAction::Zoom};
/// As IHE's Basic Image Review starts: left runs through the frames, Shift+left pans.
inline constexpr MousePreset scrollMouse{DragAction::Frames, DragAction::Pan, DragAction::Pan, DragAction::Zoom};

}   // namespace angiopose::ui