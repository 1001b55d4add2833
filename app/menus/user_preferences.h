#pragma once

#include "app/menus/language_controller.h"
#include "app/menus/menu_controller.h"
#include "app/menus/shortcut_controller.h"

namespace angiopose::app {

/// User preferences that persist between sessions; none belongs to a case.
class UserPreferences {
public:
    /// Parts of the main window to which the preferences apply.
    struct Ui {
        ui::WindowActions& actions;
        ui::AngiogramView& view;
        ui::TreeView& treeView;
        ui::BottomStrip& strip;
        QWidget& window;
    };
    UserPreferences(BranchController& branches, const Ui& ui)
        : colors_(ui.actions, ui.view, ui.treeView, ui.window),
          language_(ui.actions, ui.window),
          mouse_(ui.actions, ui.view),
          shortcuts_(ui.actions, ui.window),
          menus_(branches, ui.actions, ui.view, ui.treeView, ui.window),
          screenshots_(ui.actions, ui.strip, ui.window)
    {
    }

    LanguageController& language() { return language_; }
    ShortcutController& shortcuts() { return shortcuts_; }

private:
    ColorController colors_;
    LanguageController language_;
    MousePresetController mouse_;
    ShortcutController shortcuts_;
    MenuController menus_;
    ScreenshotController screenshots_;
};

}   // namespace angiopose::app
