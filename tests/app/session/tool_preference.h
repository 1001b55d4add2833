#pragma once

#include "app/case_controller.h"
#include "tests/app/session/random_hand.h"
#include "ui/main_window.h"

#include <QString>

#include <vector>

namespace angiopose::test {

/// Where the random user sits.
struct Desk {
    ui::MainWindow& window;
    app::CaseController& controller;
    RandomHand& hand;
    QString folder;   ///< for what is written
};

/// One thing the user does, as often as its weight among all says. Gives back what was done, in words; empty: nothing,
/// since there was nothing to do it with.
struct ToolPreference {
    int weight;
    QString (*act)(Desk&);
};

/// On the angiogram: keys, drags, wheel, clicks, menus, drawing curves.
std::vector<ToolPreference> imagePreferences();
/// In 3-D view, slices, branch list.
std::vector<ToolPreference> vesselPreferences();
/// In the columns: numbers, choices, buttons, lists, tables.
std::vector<ToolPreference> panelPreferences();
/// Through menus and dialogs: every command, recovery, saving and exporting.
std::vector<ToolPreference> commandPreferences();

/// Some random acts in a dialog that is open: clicks, ticks, rows, words. What it led to may be another dialog.
void workIn(QWidget& dialog, RandomHand& hand);

}   // namespace angiopose::test