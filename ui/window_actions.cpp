#include "ui/window_actions.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>

#include <array>
#include <vector>

namespace ui {
namespace {

enum class Menu { File, Edit, Vessels, Registration, View, Theme, Language, Mouse, Help };
enum class Kind { Plain, Switch };

struct ActionRow {
    Command command;
    Menu menu;
    const char* text;
    const char* keys;   ///< separated by "; "
    Kind kind = Kind::Plain;
};

const std::vector<ActionRow>& rows()
{
    static const std::vector<ActionRow> table{
        {Command::Open, Menu::File, QT_TRANSLATE_NOOP("ui::WindowActions", "Open …"), "Ctrl+O"},
        {Command::OpenFolder, Menu::File, QT_TRANSLATE_NOOP("ui::WindowActions", "Open DICOM folder …"),
         "Ctrl+Shift+O"},
        {Command::OpenSample, Menu::File, QT_TRANSLATE_NOOP("ui::WindowActions", "Open sample case"), ""},
        {Command::Save, Menu::File, QT_TRANSLATE_NOOP("ui::WindowActions", "Save"), "Ctrl+S"},
        {Command::SaveAs, Menu::File, QT_TRANSLATE_NOOP("ui::WindowActions", "Save as …"), "Ctrl+Shift+S"},
        {Command::ExportOverlay, Menu::File, QT_TRANSLATE_NOOP("ui::WindowActions", "Export overlay …"), "Ctrl+E"},
        {Command::ExportResult, Menu::File, QT_TRANSLATE_NOOP("ui::WindowActions", "Export result …"), ""},
        {Command::ExportPose, Menu::File, QT_TRANSLATE_NOOP("ui::WindowActions", "Export pose …"), ""},
        {Command::ExportTrace, Menu::File, QT_TRANSLATE_NOOP("ui::WindowActions", "Export traced vessels …"), ""},
        {Command::SaveWindow, Menu::File, QT_TRANSLATE_NOOP("ui::WindowActions", "Save picture of the window …"),
         "F12"},
        {Command::Close, Menu::File, QT_TRANSLATE_NOOP("ui::WindowActions", "Quit"), "Ctrl+Q"},
        {Command::Undo, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Undo"), "Ctrl+Z"},
        {Command::Redo, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Redo"), "Ctrl+Shift+Z; Ctrl+Y"},
        {Command::Nudge, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Nudge mode"), "N", Kind::Switch},
        {Command::EditVessels, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Edit traced vessels"), "E",
         Kind::Switch},
        {Command::TraceAgain, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Trace this frame again"), ""},
        {Command::Subtract, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Subtract mask, native"), "B",
         Kind::Switch},
        {Command::ShiftMask, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Move the mask by hand"), "Shift+B",
         Kind::Switch},
        {Command::MaskHere, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "This frame is the mask"), "Ctrl+B"},
        {Command::Composite, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Whole run in one picture"), "Shift+C",
         Kind::Switch},
        {Command::ResetPose, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Back to start pose"), "Backspace"},
        {Command::CopyPose, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Copy pose as matrix"), "Ctrl+C"},
        {Command::Landmarks, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Click pairs of landmarks"), "L",
         Kind::Switch},
        {Command::PlaceByLandmarks, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Place vessels by landmarks"),
         "Shift+L"},
        {Command::StartFromAngles, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Start pose from the angles"),
         "Ctrl+Backspace"},
        {Command::StartHere, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "This pose is the start pose"),
         "Shift+Backspace"},
        {Command::CopyWindow, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Copy picture of the window"),
         "Ctrl+Shift+C"},
        {Command::ToggleAuxiliary, Menu::Edit,
         QT_TRANSLATE_NOOP("ui::WindowActions", "Selected branches auxiliary on or off"), "A"},
        {Command::AuxiliaryInView, Menu::Edit,
         QT_TRANSLATE_NOOP("ui::WindowActions", "Auxiliary: the branches in view"), "V"},
        {Command::AuxiliaryWide, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Auxiliary: the wider half"),
         "Shift+V"},
        {Command::Lasso, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Auxiliary: draw a lasso"), "Ctrl+L",
         Kind::Switch},
        {Command::AuxiliaryAdvice, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Auxiliary: which branches …"),
         "Shift+A"},
        {Command::ToggleExcluded, Menu::Edit,
         QT_TRANSLATE_NOOP("ui::WindowActions", "Exclude or include selected branches"), "X"},
        {Command::SelectAll, Menu::Edit, QT_TRANSLATE_NOOP("ui::WindowActions", "Select all branches"), "Ctrl+A"},
        {Command::TraceScan, Menu::Vessels, QT_TRANSLATE_NOOP("ui::WindowActions", "Trace the scan again"), "Ctrl+T"},
        {Command::FindBranch, Menu::Vessels, QT_TRANSLATE_NOOP("ui::WindowActions", "Find a branch"), "Ctrl+F"},
        {Command::RenameBranch, Menu::Vessels, QT_TRANSLATE_NOOP("ui::WindowActions", "Rename branch"), "F2"},
        {Command::CutBranch, Menu::Vessels, QT_TRANSLATE_NOOP("ui::WindowActions", "Cut branch at the cross-hair"),
         "Ctrl+K"},
        {Command::JoinBranches, Menu::Vessels, QT_TRANSLATE_NOOP("ui::WindowActions", "Join two branches"), "Ctrl+J"},
        {Command::SmoothBranches, Menu::Vessels, QT_TRANSLATE_NOOP("ui::WindowActions", "Smooth branches"), "Ctrl+M"},
        {Command::RootAtBranch, Menu::Vessels,
         QT_TRANSLATE_NOOP("ui::WindowActions", "Root at the branch's end near the cross-hair"), "Ctrl+Home"},
        {Command::HideBranches, Menu::Vessels, QT_TRANSLATE_NOOP("ui::WindowActions", "Hide or show branches"),
         "Shift+H"},
        {Command::ShowAllBranches, Menu::Vessels, QT_TRANSLATE_NOOP("ui::WindowActions", "Show all branches"),
         "Ctrl+Shift+H"},
        {Command::DeleteBranches, Menu::Vessels, QT_TRANSLATE_NOOP("ui::WindowActions", "Delete branches"), "Delete"},
        {Command::DeleteSubtrees, Menu::Vessels,
         QT_TRANSLATE_NOOP("ui::WindowActions", "Delete branches and what leaves them"), "Shift+Delete"},
        {Command::PruneTree, Menu::Vessels, QT_TRANSLATE_NOOP("ui::WindowActions", "Prune short or thin branches …"),
         "Ctrl+P"},
        {Command::MendGap, Menu::Vessels, QT_TRANSLATE_NOOP("ui::WindowActions", "Join the pieces at the next gap"),
         "Ctrl+G"},
        {Command::Register, Menu::Registration, QT_TRANSLATE_NOOP("ui::WindowActions", "Register"), "R"},
        {Command::Stop, Menu::Registration, QT_TRANSLATE_NOOP("ui::WindowActions", "Stop and keep the best pose"),
         "Shift+R"},
        {Command::KeepPose, Menu::Registration, QT_TRANSLATE_NOOP("ui::WindowActions", "Keep this pose"), "K"},
        {Command::SwitchPoses, Menu::Registration,
         QT_TRANSLATE_NOOP("ui::WindowActions", "Switch between poses A and B"), "Y"},
        {Command::ComparePoses, Menu::Registration,
         QT_TRANSLATE_NOOP("ui::WindowActions", "Compare poses and methods …"), "Shift+K"},
        {Command::BlindTrial, Menu::Registration, QT_TRANSLATE_NOOP("ui::WindowActions", "Blind observer trial …"), ""},
        {Command::TrialDone, Menu::Registration, QT_TRANSLATE_NOOP("ui::WindowActions", "Trial done"), "Ctrl+Return"},
        {Command::Fit, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Fit the image to the window"), "1"},
        {Command::AutoWindow, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Automatic brightness"), "0"},
        {Command::Invert, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Invert grey values"), "I", Kind::Switch},
        {Command::FullRange, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Brightness: every grey value"), "9"},
        {Command::MoreContrast, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "More contrast"), "8"},
        {Command::LessContrast, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Less contrast"), "7"},
        {Command::FromSource, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Seen from the source (mirrored)"),
         "Q", Kind::Switch},
        {Command::Outline, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Vessels: centreline, outline, tube"),
         "O"},
        {Command::DepthCue, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Near vessels bright, far ones dim"),
         "D", Kind::Switch},
        {Command::Swipe, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Swipe, lens, off"), "S"},
        {Command::WorstBranch, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Zoom to the worst branch, the next"),
         "W"},
        {Command::ShowTrace, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Show traced vessels"), "T",
         Kind::Switch},
        {Command::Flicker, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Flicker start pose and pose"), "F",
         Kind::Switch},
        {Command::Replay, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Replay the last run"), "P", Kind::Switch},
        {Command::Swing, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Swing along what the image cannot tell"),
         "U", Kind::Switch},
        {Command::NextSolution, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Show the run's other solutions"),
         "J"},
        {Command::TakeSolution, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Take the solution shown"),
         "Shift+J"},
        {Command::LessOpacity, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Overlay fainter"), "["},
        {Command::MoreOpacity, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Overlay stronger"), "]"},
        {Command::Cine, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Play frames"), "C", Kind::Switch},
        {Command::Opacification, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Opacification over time"), "G"},
        {Command::HideIdentity, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Hide patient identity"), "Shift+P",
         Kind::Switch},
        {Command::ResetTreeView, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Reset 3-D view"), "3"},
        {Command::NextCornerView, Menu::View,
         QT_TRANSLATE_NOOP("ui::WindowActions", "3-D, axial, coronal, sagittal below the branches"), "2"},
        {Command::SlicesLarge, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Slices instead of the angiogram"),
         "M", Kind::Switch},
        {Command::ImageOnly, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Image alone, without the columns"),
         "4", Kind::Switch},
        {Command::FullScreen, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Full screen"), "F11", Kind::Switch},
        {Command::ReduceMotion, Menu::View, QT_TRANSLATE_NOOP("ui::WindowActions", "Reduce motion"), "", Kind::Switch},
        {Command::ThemeDark, Menu::Theme, QT_TRANSLATE_NOOP("ui::WindowActions", "Dark"), "", Kind::Switch},
        {Command::ThemeLight, Menu::Theme, QT_TRANSLATE_NOOP("ui::WindowActions", "Light"), "", Kind::Switch},
        {Command::ThemeSystem, Menu::Theme, QT_TRANSLATE_NOOP("ui::WindowActions", "As the desktop"), "", Kind::Switch},
        {Command::LanguageSystem, Menu::Language, QT_TRANSLATE_NOOP("ui::WindowActions", "Language of the desktop"), "",
         Kind::Switch},
        {Command::LanguageEnglish, Menu::Language, "English", "", Kind::Switch},
        {Command::LanguageGerman, Menu::Language, "Deutsch", "", Kind::Switch},
        {Command::LanguageChinese, Menu::Language, "简体中文", "", Kind::Switch},
        {Command::MouseRadiology, Menu::Mouse, QT_TRANSLATE_NOOP("ui::WindowActions", "Radiology: left drag windows"),
         "", Kind::Switch},
        {Command::MouseSlicer, Menu::Mouse, QT_TRANSLATE_NOOP("ui::WindowActions", "3D Slicer: left only picks"), "",
         Kind::Switch},
        {Command::MouseScroll, Menu::Mouse, QT_TRANSLATE_NOOP("ui::WindowActions", "Scroll: left drag runs the frames"),
         "", Kind::Switch},
        {Command::PanelHelp, Menu::Help, QT_TRANSLATE_NOOP("ui::WindowActions", "Help on what the mouse points at"),
         "F1"},
        {Command::Tour, Menu::Help, QT_TRANSLATE_NOOP("ui::WindowActions", "Short tour"), ""},
        {Command::GoodFit, Menu::Help, QT_TRANSLATE_NOOP("ui::WindowActions", "What a good fit looks like"),
         "Shift+F1"},
        {Command::Keys, Menu::Help, QT_TRANSLATE_NOOP("ui::WindowActions", "Keys and mouse"), "?; Ctrl+F1"},
        {Command::About, Menu::Help, QT_TRANSLATE_NOOP("ui::WindowActions", "About AngioPose"), ""},
    };
    return table;
}

struct KeyNote {
    const char* keys;
    const char* effect;
};

constexpr std::array nudgeNotes{
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "← → ↑ ↓"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "move by 1 mm (Shift 10 mm, Ctrl 0.1 mm)")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "PgUp PgDn"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "move away from or to the source")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", ", ."), QT_TRANSLATE_NOOP("ui::WindowActions", "roll by 1°")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "Alt+arrows"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "turn LAO/RAO and CRA/CAU by 1°")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "drag"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "move; on the ring roll; Esc takes it back, then ends the mode")},
};

constexpr std::array landmarkNotes{
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "click"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "in 3-D or a slice, then in the image: one pair")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "drag"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "a node of the vessels to its place, or a cross elsewhere")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "Enter"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "place the vessels by the pairs")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "Del"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "remove the last pair")},
};

constexpr std::array curveNotes{
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "X"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "click curves that are no vessels")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "E"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "erase with a brush; [ ] its size")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "D"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "draw: Enter ends, Backspace takes a point back, Shift straight")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "C"), QT_TRANSLATE_NOOP("ui::WindowActions", "cut a curve")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "B L"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "box or lasso around what counts; Ctrl: around what does not")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "✓ ✗"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "dashed curves may be a catheter: keep or leave out")},
};

constexpr std::array viewNotes{
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "Ctrl+wheel"), QT_TRANSLATE_NOOP("ui::WindowActions", "zoom")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "wheel, ↑ ↓, Home, End"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "frames")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "H (hold)"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "hide the overlay")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "click"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "pick a branch (Ctrl adds)")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "right click"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "menu of what can be done here")},
};

constexpr std::array sliceNotes{
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "click, left drag, Ctrl+arrows"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "cross-hair, linked with all views")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "Enter"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "picks the point at the cross-hair, as a click does")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "wheel, ↑ ↓, PgUp PgDn"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "slices (Shift 10)")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "right drag"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "window and level; a right click opens the menu")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "middle drag, Ctrl+wheel"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "pan and zoom")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "double click"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "all slices large, and back")},
};

constexpr std::array treeNotes{
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "left drag, arrows"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "turn")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "middle drag"), QT_TRANSLATE_NOOP("ui::WindowActions", "pan")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "right drag, wheel, + −"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "zoom")},
    KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "double click"),
            QT_TRANSLATE_NOOP("ui::WindowActions", "everything in view again")},
};

const char* effectOf(DragAction action)
{
    switch (action) {
        case DragAction::WindowLevel:
            return QT_TRANSLATE_NOOP("ui::WindowActions", "window and level");
        case DragAction::Pan:
            return QT_TRANSLATE_NOOP("ui::WindowActions", "pan");
        case DragAction::Zoom:
            return QT_TRANSLATE_NOOP("ui::WindowActions", "zoom");
        case DragAction::Frames:
            return QT_TRANSLATE_NOOP("ui::WindowActions", "frames");
        case DragAction::None:
            break;
    }
    return QT_TRANSLATE_NOOP("ui::WindowActions", "nothing");
}

std::array<KeyNote, 5> mouseNotes(const MousePreset& mouse)
{
    return {KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "left drag"), effectOf(mouse.left)},
            KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "Shift+left drag"), effectOf(mouse.shiftLeft)},
            KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "Ctrl+left drag"), effectOf(DragAction::WindowLevel)},
            KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "middle drag"), effectOf(mouse.middle)},
            KeyNote{QT_TRANSLATE_NOOP("ui::WindowActions", "right drag"), effectOf(mouse.right)}};
}

QString translated(const char* text)
{
    return QCoreApplication::translate("ui::WindowActions", text);
}

QList<QKeySequence> shortcutsOf(const ActionRow& row)
{
    const QString keys = QString::fromLatin1(row.keys);
    return keys.isEmpty() ? QList<QKeySequence>() : QKeySequence::listFromString(keys);
}

/// "Copy pose as matrix" → "copy-pose-as-matrix": the command's name in the settings, the same in every language.
QString slugOf(const char* text)
{
    static const QRegularExpression rest(QStringLiteral("[^a-z0-9]+"));
    return QString::fromUtf8(text).toLower().replace(rest, QStringLiteral("-"));
}

template <class Notes>
void addNotes(std::vector<KeyLine>& lines, const QString& heading, const Notes& notes)
{
    for (const KeyNote& note : notes) {
        lines.push_back({heading, translated(note.keys), translated(note.effect)});
    }
}

bool startsGroup(Command command)
{
    return command == Command::Save || command == Command::ExportOverlay || command == Command::Close ||
           command == Command::Nudge || command == Command::ToggleAuxiliary || command == Command::Outline ||
           command == Command::Cine || command == Command::RenameBranch || command == Command::DeleteBranches ||
           command == Command::KeepPose || command == Command::BlindTrial || command == Command::ImageOnly ||
           command == Command::FullScreen || command == Command::Keys;
}

}   // namespace

WindowActions::WindowActions(QWidget* window) : QObject(window), recent_(new QMenu(tr("Open recent"), window))
{
    std::map<Menu, QActionGroup*> choices{{Menu::Theme, new QActionGroup(this)},
                                          {Menu::Language, new QActionGroup(this)},
                                          {Menu::Mouse, new QActionGroup(this)}};
    for (const ActionRow& row : rows()) {
        auto* action = new QAction(translated(row.text), this);
        action->setObjectName(slugOf(row.text));
        action->setCheckable(row.kind == Kind::Switch);
        action->setShortcuts(shortcutsOf(row));
        action->setAutoRepeat(row.command == Command::MoreOpacity || row.command == Command::LessOpacity ||
                              row.command == Command::MoreContrast || row.command == Command::LessContrast ||
                              row.command == Command::Undo || row.command == Command::Redo);
        if (const auto group = choices.find(row.menu); group != choices.end()) {
            group->second->addAction(action);
        }
        window->addAction(action);
        actions_[row.command] = action;
    }
}

void WindowActions::fillMenus(QMenuBar* menuBar)
{
    std::map<Menu, QMenu*> menus;
    menus[Menu::File] = menuBar->addMenu(tr("&File"));
    menus[Menu::Edit] = menuBar->addMenu(tr("&Edit"));
    menus[Menu::Vessels] = menuBar->addMenu(tr("&Vessels"));
    menus[Menu::Registration] = menuBar->addMenu(tr("&Registration"));
    menus[Menu::View] = menuBar->addMenu(tr("&View"));
    menus[Menu::Help] = menuBar->addMenu(tr("&Help"));
    menus[Menu::Theme] = new QMenu(tr("Theme"), menuBar);
    menus[Menu::Language] = new QMenu(tr("Language"), menuBar);
    menus[Menu::Mouse] = new QMenu(tr("Mouse"), menuBar);
    for (const ActionRow& row : rows()) {
        if (startsGroup(row.command)) {
            menus[row.menu]->addSeparator();
        }
        menus[row.menu]->addAction(actions_.at(row.command));
        if (row.command == Command::OpenSample) {
            menus[Menu::File]->addMenu(recent_);
        }
    }
    menus[Menu::View]->addMenu(menus[Menu::Theme]);
    menus[Menu::View]->addMenu(menus[Menu::Language]);
    menus[Menu::View]->addMenu(menus[Menu::Mouse]);
}

std::vector<KeyLine> WindowActions::keySheet(const MousePreset& mouse) const
{
    std::vector<KeyLine> lines;
    for (const ActionRow& row : rows()) {
        QAction* action = actions_.at(row.command);
        lines.push_back({tr("In the whole window"),
                         QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText),
                         translated(row.text), action});
    }
    addNotes(lines, tr("In nudge mode"), nudgeNotes);
    addNotes(lines, tr("While clicking landmarks"), landmarkNotes);
    addNotes(lines, tr("While editing vessels"), curveNotes);
    addNotes(lines, tr("On the angiogram"), mouseNotes(mouse));
    addNotes(lines, tr("On the angiogram"), viewNotes);
    addNotes(lines, tr("On the 3-D view"), treeNotes);
    addNotes(lines, tr("On a slice"), sliceNotes);
    return lines;
}

}   // namespace ui
