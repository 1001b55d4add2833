#pragma once

#include "ui/actions/command.h"

#include <QCoreApplication>

#include <span>

namespace angiopose::ui {

enum class Menu {
    File,
    Exports,
    Edit,
    Vessels,
    Angiogram,
    Pose,
    Registration,
    View,
    Brightness,
    Places,
    Colors,
    Theme,
    Language,
    Mouse,
    Help
};

/// Command with its label, shortcuts (separated by "; ") and traits.
struct CommandRow {
    Command command;
    const char* name;   ///< object name and settings key, e.g. "copy-pose-as-matrix"; must never change
    const char* text;   ///< English source text, translated by CommandTable::tr
    const char* keys = "";
    unsigned traits = 0;
};

struct MenuRows {
    Menu menu;
    const char* title;
    std::span<const CommandRow> commands;
};

/// Single list of all commands, from which menus, shortcuts and the shortcut sheet are built.
class CommandTable {
    Q_DECLARE_TR_FUNCTIONS(angiopose::ui::CommandTable)
public:
    enum Trait : unsigned {
        Switch = 1,   ///< checkable command, which stays on until it is triggered again
        StartsGroup = 2,   ///< command preceded by a separator
        Repeats = 4   ///< command that repeats while its key is held
    };

    /// Menus in menu-bar order; Exports is a submenu of File, and Brightness to Mouse are submenus of View.
    static std::span<const MenuRows> menus();

private:
    static std::span<const CommandRow> fileCommands();
    static std::span<const CommandRow> exportCommands();
    static std::span<const CommandRow> editCommands();
    static std::span<const CommandRow> vesselsCommands();
    static std::span<const CommandRow> angiogramCommands();
    static std::span<const CommandRow> poseCommands();
    static std::span<const CommandRow> registrationCommands();
    static std::span<const CommandRow> viewCommands();
    static std::span<const CommandRow> brightnessCommands();
    static std::span<const CommandRow> layoutCommands();
    static std::span<const CommandRow> colorCommands();
    static std::span<const CommandRow> themeCommands();
    static std::span<const CommandRow> languageCommands();
    static std::span<const CommandRow> mouseCommands();
    static std::span<const CommandRow> helpCommands();
};

}   // namespace angiopose::ui
