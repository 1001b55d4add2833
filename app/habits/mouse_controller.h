#pragma once

#include "ui/actions/mouse_preset.h"

#include <QObject>

namespace angiopose::ui {
class AngiogramView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// The preset that the user chose.
ui::MousePreset chosenMouse();

/// The mouse menu: which button does what on the angiogram.
class MouseController : public QObject {
    Q_OBJECT
public:
    MouseController(ui::WindowActions& actions, ui::AngiogramView& view, QObject* parent = nullptr);
};

}   // namespace angiopose::app