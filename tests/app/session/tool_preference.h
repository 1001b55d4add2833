#pragma once

#include "app/case_controller.h"
#include "tests/app/session/random_hand.h"
#include "ui/main_window.h"

#include <QString>

#include <vector>

namespace angiopose::test {

/// Everything that the random user works with.
struct Desk {
    ui::MainWindow& window;
    app::CaseController& controller;
    RandomHand& hand;
    QString folder;   ///< folder for the written files
};

/// One kind of user action, chosen in proportion to its weight. Returns a description of the action; empty if there was
/// nothing to apply it to.
struct ToolPreference {
    int weight;
    QString (*act)(Desk&);
};

/// Actions on the angiogram: keys, drags, wheel, clicks, menus, drawing curves.
std::vector<ToolPreference> imagePreferences();
/// Actions in the 3-D view, the slices and the branch list.
std::vector<ToolPreference> vesselPreferences();
/// Actions in the columns: numbers, choices, buttons, lists, tables.
std::vector<ToolPreference> panelPreferences();
/// Actions through menus and dialogs: every command, recovery, saving and exporting.
std::vector<ToolPreference> commandPreferences();

/// Performs some random actions in an open dialog: clicks, check boxes, rows, text. They may open another dialog.
void workIn(QWidget& dialog, RandomHand& hand);

}   // namespace angiopose::test
