#pragma once

#include "app/habits/color_controller.h"
#include "app/habits/language_controller.h"
#include "app/habits/menu_controller.h"
#include "app/habits/mouse_controller.h"
#include "app/habits/picture_controller.h"
#include "app/habits/shortcut_controller.h"

namespace angiopose::app {

/// How each user likes the program to be: everything here is remembered between sessions, nothing belongs to a case.
class Habits {
public:
    Habits(BranchController& branches, ui::MainWindow& window)
        : colors_(window),
          language_(window),
          mouse_(window),
          shortcuts_(window),
          menus_(branches, window),
          pictures_(window)
    {
    }

    LanguageController& language() { return language_; }
    ShortcutController& shortcuts() { return shortcuts_; }

private:
    ColorController colors_;
    LanguageController language_;
    MouseController mouse_;
    ShortcutController shortcuts_;
    MenuController menus_;
    PictureController pictures_;
};

}   // namespace angiopose::app