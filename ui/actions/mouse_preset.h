#pragma once

#include <Qt>

namespace angiopose::ui {

/// Action of a mouse drag on the angiogram while no tool handles it.
enum class DragAction { None, WindowLevel, Pan, Zoom, Frames };

/// Mouse conventions of other programs: one drag action per button. Ctrl+left adjusts window/level in every preset.
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

/// As in most viewers (Weasis, OHIF): the left button adjusts window/level, the middle one pans, the right one zooms.
inline constexpr MousePreset radiologyMouse{};
/// As in 3D Slicer: the left button only picks; Shift+left and the middle one pan, the right one zooms.
inline constexpr MousePreset slicerMouse{DragAction::None, DragAction::Pan, DragAction::Pan, DragAction::Zoom};
/// Default of IHE Basic Image Review: the left button scrolls through the frames, Shift+left pans.
inline constexpr MousePreset scrollMouse{DragAction::Frames, DragAction::Pan, DragAction::Pan, DragAction::Zoom};

}   // namespace angiopose::ui
