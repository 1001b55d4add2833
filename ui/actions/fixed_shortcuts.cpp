#include "ui/actions/fixed_shortcuts.h"

#include <QCoreApplication>

#include <initializer_list>

namespace angiopose::ui {
namespace {

struct KeyNotes {
    Q_DECLARE_TR_FUNCTIONS(angiopose::ui::KeyNotes)
public:
    static void addModes(std::vector<ShortcutRow>& lines);
    static void addAngiogram(std::vector<ShortcutRow>& lines, const MousePreset& mouse);
    static void addVolumeViews(std::vector<ShortcutRow>& lines);
    static QString effectOf(DragAction action);
};

struct KeyNote {
    QString keys;
    QString effect;
};

void add(std::vector<ShortcutRow>& lines, const QString& heading, std::initializer_list<KeyNote> notes)
{
    for (const KeyNote& note : notes) {
        lines.push_back({heading, note.keys, note.effect});
    }
}

QString KeyNotes::effectOf(DragAction action)
{
    switch (action) {
        case DragAction::WindowLevel:
            return tr("window and level");
        case DragAction::Pan:
            return tr("pan");
        case DragAction::Zoom:
            return tr("zoom");
        case DragAction::Frames:
            return tr("frames");
        case DragAction::None:
            break;
    }
    return tr("nothing");
}

void KeyNotes::addModes(std::vector<ShortcutRow>& lines)
{
    add(lines, tr("In nudge mode"),
        {{tr("← → ↑ ↓"), tr("move by 1 mm (Shift 10 mm, Ctrl 0.1 mm)")},
         {tr("PgUp PgDn"), tr("move away from or toward the source")},
         {tr(", ."), tr("roll by 1°")},
         {tr("Alt+arrows"), tr("rotate LAO/RAO and CRA/CAU by 1°")},
         {tr("drag"), tr("move; drag the ring to roll; Esc reverts, then ends the mode")}});
    add(lines, tr("While setting the rotation center"),
        {{tr("click"), tr("a point on the vessels, in the image, in 3-D or in a slice")},
         {tr("← →"), tr("next bifurcation or branch end")},
         {tr("Enter"), tr("accept the point shown")},
         {tr("Del"), tr("reset to the centroid")}});
    add(lines, tr("While picking landmarks"),
        {{tr("click"), tr("set one pair: click in 3-D or in a slice, then in the image")},
         {tr("drag"), tr("drag a vessel node to its position, or move a landmark cross")},
         {tr("Enter"), tr("register the vessels from the landmark pairs")},
         {tr("Del"), tr("remove the last pair")}});
    add(lines, tr("While measuring"),
        {{tr("click, drag"), tr("set a point, or move an existing one")},
         {tr("Enter, double-click"), tr("close an area")},
         {tr("Backspace"), tr("remove the last point")},
         {tr("Del"), tr("remove the selected measurement or the last one")}});
    add(lines, tr("While marking"),
        {{tr("click"), tr("add a target point or ring to the vessels, here, in 3-D or in a slice")},
         {tr("drag"), tr("draw an arrow or move an existing mark")},
         {tr("Enter"), tr("finish the text; Esc discards it")},
         {tr("Del"), tr("remove the selected mark or the last one")}});
    add(lines, tr("While editing vessels"),
        {{tr("X"), tr("exclude curves that are not vessels")},
         {tr("E"), tr("erase with a brush; [ ] changes its size")},
         {tr("D"), tr("draw: Enter ends, Backspace removes a point, Shift draws straight lines")},
         {tr("C"), tr("cut a curve")},
         {tr("B L"), tr("box or lasso around non-vessels; Ctrl: keep only the inside")},
         {tr("✓ ✗"), tr("dashed curves may be catheters: keep or exclude them")},
         {tr("S, then A or Del"), tr("next dashed curve: keep or exclude")}});
}

void KeyNotes::addAngiogram(std::vector<ShortcutRow>& lines, const MousePreset& mouse)
{
    add(lines, tr("In the angiogram"),
        {{tr("left drag"), effectOf(mouse.left)},
         {tr("Shift+left drag"), effectOf(mouse.shiftLeft)},
         {tr("Ctrl+left drag"), effectOf(DragAction::WindowLevel)},
         {tr("middle drag"), effectOf(mouse.middle)},
         {tr("right drag"), effectOf(mouse.right)}});
    add(lines, tr("In the angiogram"),
        {{tr("Ctrl+wheel"), tr("zoom")},
         {tr("wheel, ↑ ↓, Home, End"), tr("frames")},
         {tr("H (hold)"), tr("hide the overlay")},
         {tr("click"), tr("select a branch (Ctrl adds)")},
         {tr("double-click"), tr("show only this view, or restore")},
         {tr("right-click"), tr("context menu")}});
}

void KeyNotes::addVolumeViews(std::vector<ShortcutRow>& lines)
{
    add(lines, tr("In the 3-D view"),
        {{tr("left drag, arrows"), tr("turn")},
         {tr("middle drag"), tr("pan")},
         {tr("right drag, wheel, + −"), tr("zoom")},
         {tr("double-click"), tr("show only this view, or restore")}});
    add(lines, tr("In a slice"),
        {{tr("click, left drag, Ctrl+arrows"), tr("crosshair, linked across all views")},
         {tr("Enter"), tr("pick the point at the crosshair (same as a click)")},
         {tr("wheel, ↑ ↓, PgUp PgDn"), tr("slices (Shift 10)")},
         {tr("right drag"), tr("window and level; right-click opens the menu")},
         {tr("middle drag, Ctrl+wheel"), tr("pan and zoom")},
         {tr("double-click"), tr("enlarge all slices, or restore")}});
}

}   // namespace

std::vector<ShortcutRow> fixedShortcuts(const MousePreset& mouse)
{
    std::vector<ShortcutRow> lines;
    KeyNotes::addModes(lines);
    KeyNotes::addAngiogram(lines, mouse);
    KeyNotes::addVolumeViews(lines);
    return lines;
}

}   // namespace angiopose::ui
