#pragma once

#include "ui/dialogs/key_sheet.h"
#include "ui/views/mouse_preset.h"

#include <QAction>
#include <QObject>

#include <map>
#include <vector>

class QMenu;
class QMenuBar;
class QWidget;

namespace ui {

/// Everything the window can be asked to do.
enum class Command {
    Open,
    OpenFolder,
    OpenSample,
    Save,
    SaveAs,
    ExportOverlay,
    ExportResult,
    ExportPose,
    ExportTrace,
    Close,
    Undo,
    Redo,
    Nudge,
    EditVessels,
    TraceAgain,
    Subtract,
    ShiftMask,
    MaskHere,
    Composite,
    Opacification,
    ResetPose,
    ToggleAuxiliary,
    ToggleExcluded,
    SelectAll,
    TraceScan,
    FindBranch,
    RenameBranch,
    CutBranch,
    JoinBranches,
    SmoothBranches,
    RootAtBranch,
    HideBranches,
    ShowAllBranches,
    DeleteBranches,
    DeleteSubtrees,
    PruneTree,
    MendGap,
    Landmarks,
    PlaceByLandmarks,
    StartFromAngles,
    StartHere,
    Register,
    Stop,
    Fit,
    AutoWindow,
    Invert,
    Outline,
    Swipe,
    DepthCue,
    WorstBranch,
    Replay,
    Swing,
    NextSolution,
    TakeSolution,
    FullRange,
    MoreContrast,
    LessContrast,
    CopyPose,
    Lasso,
    AuxiliaryAdvice,
    KeepPose,
    SwitchPoses,
    ComparePoses,
    BlindTrial,
    TrialDone,
    CopyWindow,
    SaveWindow,
    AuxiliaryInView,
    AuxiliaryWide,
    ShowTrace,
    FromSource,
    Flicker,
    MoreOpacity,
    LessOpacity,
    HideIdentity,
    Cine,
    ResetTreeView,
    SlicesLarge,
    NextCornerView,
    ImageOnly,
    FullScreen,
    ReduceMotion,
    ThemeDark,
    ThemeLight,
    ThemeSystem,
    LanguageSystem,
    LanguageEnglish,
    LanguageGerman,
    LanguageChinese,
    MouseRadiology,
    MouseSlicer,
    MouseScroll,
    PanelHelp,
    Tour,
    GoodFit,
    Keys,
    About
};

/// The window's named actions with their keys, made from one table that also feeds menus and key sheet.
class WindowActions : public QObject {
    Q_OBJECT
public:
    explicit WindowActions(QWidget* window);

    QAction* operator[](Command command) const { return actions_.at(command); }
    QMenu* recentMenu() const { return recent_; }
    void fillMenus(QMenuBar* menuBar);
    /// Every command with its key, the keys that are fixed, and what the mouse does.
    std::vector<KeyLine> keySheet(const MousePreset& mouse) const;

private:
    std::map<Command, QAction*> actions_;
    QMenu* recent_;
};

}   // namespace ui
