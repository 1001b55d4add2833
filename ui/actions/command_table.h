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

/// What a command says, its keys separated by "; ", and its traits.
struct CommandRow {
    Command command;
    const char* text;   ///< English, translated by CommandTable::tr
    const char* keys = "";
    unsigned traits = 0;

    QString name() const;   ///< "copy-pose-as-matrix": in the settings, the same in every language
};

struct MenuRows {
    Menu menu;
    const char* title;
    std::span<const CommandRow> commands;
};

/// The one list of all commands: menus, keys and the key sheet are made from it.
class CommandTable {
    Q_DECLARE_TR_FUNCTIONS(angiopose::ui::CommandTable)
public:
    enum Trait : unsigned {
        Switch = 1,   ///< stays on until called again
        StartsGroup = 2,   ///< a separator comes before it
        Repeats = 4   ///< again and again while the key is held
    };

    /// Menus in the order of the bar; Exports lies in File, from Brightness to Mouse they lie in View.
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
    static std::span<const CommandRow> placesCommands();
    static std::span<const CommandRow> colorCommands();
    static std::span<const CommandRow> themeCommands();
    static std::span<const CommandRow> languageCommands();
    static std::span<const CommandRow> mouseCommands();
    static std::span<const CommandRow> helpCommands();
};

}   // namespace angiopose::ui