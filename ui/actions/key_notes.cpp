#include "ui/actions/key_notes.h"

#include <QCoreApplication>

#include <initializer_list>

namespace angiopose::ui {
namespace {

struct KeyNotes {
    Q_DECLARE_TR_FUNCTIONS(angiopose::ui::KeyNotes)
public:
    static void addModes(std::vector<KeyLine>& lines);
    static void addAngiogram(std::vector<KeyLine>& lines, const MousePreset& mouse);
    static void addVolumeViews(std::vector<KeyLine>& lines);
    static QString effectOf(DragAction action);
};

struct KeyNote {
    QString keys;
    QString effect;
};

void add(std::vector<KeyLine>& lines, const QString& heading, std::initializer_list<KeyNote> notes)
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

void KeyNotes::addModes(std::vector<KeyLine>& lines)
{
    add(lines, tr("In nudge mode"),
        {{tr("← → ↑ ↓"), tr("move by 1 mm (Shift 10 mm, Ctrl 0.1 mm)")},
         {tr("PgUp PgDn"), tr("move away from or to the source")},
         {tr(", ."), tr("roll by 1°")},
         {tr("Alt+arrows"), tr("turn LAO/RAO and CRA/CAU by 1°")},
         {tr("drag"), tr("move; on the ring roll; Esc takes it back, then ends the mode")}});
    add(lines, tr("While picking the pivot"),
        {{tr("click"), tr("a place on the vessels, in the image, in 3-D or in a slice")},
         {tr("← →"), tr("the next bifurcation or end")},
         {tr("Enter"), tr("takes the place shown")},
         {tr("Del"), tr("back to the centroid")}});
    add(lines, tr("While clicking landmarks"),
        {{tr("click"), tr("in 3-D or a slice, then in the image: one pair")},
         {tr("drag"), tr("a node of the vessels to its place, or a cross elsewhere")},
         {tr("Enter"), tr("place the vessels by the pairs")},
         {tr("Del"), tr("remove the last pair")}});
    add(lines, tr("While measuring"),
        {{tr("click, drag"), tr("set a point, or move one that is there")},
         {tr("Enter, double click"), tr("closes an area")},
         {tr("Backspace"), tr("takes a point back")},
         {tr("Del"), tr("removes the chosen measurement, or the last")}});
    add(lines, tr("While marking"),
        {{tr("click"), tr("sets a check point or ring on the vessels, here, in 3-D or in a slice")},
         {tr("drag"), tr("draws an arrow, or moves what is there")},
         {tr("Enter"), tr("ends a text; Esc drops it")},
         {tr("Del"), tr("removes the chosen mark, or the last")}});
    add(lines, tr("While editing vessels"),
        {{tr("X"), tr("click curves that are no vessels")},
         {tr("E"), tr("erase with a brush; [ ] its size")},
         {tr("D"), tr("draw: Enter ends, Backspace takes a point back, Shift straight")},
         {tr("C"), tr("cut a curve")},
         {tr("B L"), tr("box or lasso around what is no vessel; Ctrl: keep the inside alone")},
         {tr("✓ ✗"), tr("dashed curves may be a catheter: keep or leave out")},
         {tr("S, then A or Del"), tr("the next of the dashed curves: keep or leave out")}});
}

void KeyNotes::addAngiogram(std::vector<KeyLine>& lines, const MousePreset& mouse)
{
    add(lines, tr("On the angiogram"),
        {{tr("left drag"), effectOf(mouse.left)},
         {tr("Shift+left drag"), effectOf(mouse.shiftLeft)},
         {tr("Ctrl+left drag"), effectOf(DragAction::WindowLevel)},
         {tr("middle drag"), effectOf(mouse.middle)},
         {tr("right drag"), effectOf(mouse.right)}});
    add(lines, tr("On the angiogram"),
        {{tr("Ctrl+wheel"), tr("zoom")},
         {tr("wheel, ↑ ↓, Home, End"), tr("frames")},
         {tr("H (hold)"), tr("hide the overlay")},
         {tr("click"), tr("pick a branch (Ctrl adds)")},
         {tr("double click"), tr("this view alone, and back")},
         {tr("right click"), tr("menu of what can be done here")}});
}

void KeyNotes::addVolumeViews(std::vector<KeyLine>& lines)
{
    add(lines, tr("On the 3-D view"),
        {{tr("left drag, arrows"), tr("turn")},
         {tr("middle drag"), tr("pan")},
         {tr("right drag, wheel, + −"), tr("zoom")},
         {tr("double click"), tr("this view alone, and back")}});
    add(lines, tr("On a slice"),
        {{tr("click, left drag, Ctrl+arrows"), tr("cross-hair, linked with all views")},
         {tr("Enter"), tr("picks the point at the cross-hair, as a click does")},
         {tr("wheel, ↑ ↓, PgUp PgDn"), tr("slices (Shift 10)")},
         {tr("right drag"), tr("window and level; a right click opens the menu")},
         {tr("middle drag, Ctrl+wheel"), tr("pan and zoom")},
         {tr("double click"), tr("all slices large, and back")}});
}

}   // namespace

std::vector<KeyLine> keyNotes(const MousePreset& mouse)
{
    std::vector<KeyLine> lines;
    KeyNotes::addModes(lines);
    KeyNotes::addAngiogram(lines, mouse);
    KeyNotes::addVolumeViews(lines);
    return lines;
}

}   // namespace angiopose::ui