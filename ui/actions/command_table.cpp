#include "ui/actions/command_table.h"

#include <array>

namespace angiopose::ui {

std::span<const CommandRow> CommandTable::fileCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Open, "open-", QT_TR_NOOP("Open…"), "Ctrl+O"},
        {Command::OpenFolder, "open-folder-or-disc-", QT_TR_NOOP("Open DICOM folder/CD…"), "Ctrl+Shift+O"},
        {Command::QueryPacs, "open-from-archive-", QT_TR_NOOP("Query PACS…"), "Ctrl+Shift+A"},
        {Command::OpenSample, "open-sample-case", QT_TR_NOOP("Open sample case")},
        {Command::NewWindow, "new-window", QT_TR_NOOP("New window"), "Ctrl+N"},
        {Command::Save, "save", QT_TR_NOOP("Save"), "Ctrl+S", StartsGroup},
        {Command::SaveAs, "save-as-", QT_TR_NOOP("Save as…"), "Ctrl+Shift+S"},
        {Command::ExportOverlay, "export-overlay-", QT_TR_NOOP("Export overlay…"), "Ctrl+E"},
        {Command::SendToArchive, "send-to-archive-", QT_TR_NOOP("Send to PACS…"), "", StartsGroup},
        {Command::ShareCase, "pack-case-for-others-", QT_TR_NOOP("Share case as ZIP…")},
        {Command::DeidentifyFiles, "de-identify-files-", QT_TR_NOOP("De-identify files…")},
        {Command::SaveScreenshot, "save-picture-of-the-window-", QT_TR_NOOP("Save screenshot…"), "F12"},
        {Command::PrivateMode, "private-mode", QT_TR_NOOP("Private mode"), "", Switch | StartsGroup},
        {Command::WriteAuditLog, "keep-an-audit-file-", QT_TR_NOOP("Write audit log…"), "", Switch},
        {Command::CloseCase, "close-case", QT_TR_NOOP("Close case"), "Ctrl+W", StartsGroup},
        {Command::Close, "quit", QT_TR_NOOP("Quit"), "Ctrl+Q"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::exportCommands()
{
    static constexpr CommandRow rows[]{
        {Command::ExportMovie, "export-movie-", QT_TR_NOOP("Export movie…"), "Ctrl+Shift+E"},
        {Command::ExportReport, "export-report-", QT_TR_NOOP("Export report…")},
        {Command::ExportDicom, "export-dicom-objects-", QT_TR_NOOP("Export DICOM objects…")},
        {Command::ExportResult, "export-result-", QT_TR_NOOP("Export result…")},
        {Command::ExportPose, "export-pose-", QT_TR_NOOP("Export pose…")},
        {Command::ExportTrace, "export-traced-vessels-", QT_TR_NOOP("Export traced vessels…")},
        {Command::ExportVessels, "export-vessel-tree-", QT_TR_NOOP("Export vessel tree…")},
        {Command::ExportMask, "export-lumen-mask-", QT_TR_NOOP("Export lumen mask…")},
        {Command::ExportDeformed, "export-bent-vessels-", QT_TR_NOOP("Export deformed vessels…")},
        {Command::ExportTrackedPoses, "export-followed-poses-", QT_TR_NOOP("Export tracked poses…")},
        {Command::ExportMeasurements, "export-measurements-", QT_TR_NOOP("Export measurements…")},
        {Command::ExportTargetPoints, "export-check-points-", QT_TR_NOOP("Export target points…")},
        {Command::ExportBranches, "export-measures-of-the-branches-", QT_TR_NOOP("Export branch measurements…")},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::editCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Undo, "undo", QT_TR_NOOP("Undo"), "Ctrl+Z", Repeats},
        {Command::Redo, "redo", QT_TR_NOOP("Redo"), "Ctrl+Shift+Z; Ctrl+Y", Repeats},
        {Command::CopyPose, "copy-pose-as-matrix", QT_TR_NOOP("Copy pose as matrix"), "Ctrl+C", StartsGroup},
        {Command::CopyScreenshot, "copy-picture-of-the-window", QT_TR_NOOP("Copy screenshot"), "Ctrl+Shift+C"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::vesselsCommands()
{
    static constexpr CommandRow rows[]{
        {Command::TraceScan, "trace-the-scan-again", QT_TR_NOOP("Trace the scan again"), "Ctrl+T"},
        {Command::TraceBetween, "trace-one-vessel-between-two-places", QT_TR_NOOP("Trace between two points"), "Ctrl+I",
         Switch},
        {Command::ChooseLabels, "choose-the-labels-that-are-vessels", QT_TR_NOOP("Choose vessel labels"),
         "Ctrl+Shift+T"},
        {Command::PaintMask, "paint-into-the-lumen-mask", QT_TR_NOOP("Paint in lumen mask"), "Ctrl+D",
         Switch | StartsGroup},
        {Command::EraseMask, "erase-from-the-lumen-mask", QT_TR_NOOP("Erase from lumen mask"), "Ctrl+R", Switch},
        {Command::CutMask, "cut-the-lumen-mask-by-a-lasso", QT_TR_NOOP("Cut lumen mask with lasso"), "Ctrl+X", Switch},
        {Command::TraceMask, "trace-the-edited-mask", QT_TR_NOOP("Trace the edited mask"), "Ctrl+U"},
        {Command::FindBranch, "find-a-branch", QT_TR_NOOP("Find a branch"), "Ctrl+F", StartsGroup},
        {Command::SelectAll, "select-all-branches", QT_TR_NOOP("Select all branches"), "Ctrl+A"},
        {Command::RenameBranch, "rename-branch", QT_TR_NOOP("Rename branch"), "F2"},
        {Command::CutBranch, "cut-branch-at-the-cross-hair", QT_TR_NOOP("Cut branch at crosshair"), "Ctrl+K"},
        {Command::JoinBranches, "join-two-branches", QT_TR_NOOP("Join two branches"), "Ctrl+J"},
        {Command::SmoothBranches, "smooth-branches", QT_TR_NOOP("Smooth branches"), "Ctrl+M"},
        {Command::RootAtBranch, "root-at-the-branch-s-end-near-the-cross-hair",
         QT_TR_NOOP("Set root at branch end near crosshair"), "Ctrl+Home"},
        {Command::HideBranches, "hide-or-show-branches", QT_TR_NOOP("Hide or show branches"), "Shift+H", StartsGroup},
        {Command::ShowAllBranches, "show-all-branches", QT_TR_NOOP("Show all branches"), "Ctrl+Shift+H"},
        {Command::DeleteBranches, "delete-branches", QT_TR_NOOP("Delete branches"), "Delete", StartsGroup},
        {Command::DeleteSubtrees, "delete-branches-and-what-leaves-them", QT_TR_NOOP("Delete branches and descendants"),
         "Shift+Delete"},
        {Command::PruneTree, "prune-short-or-thin-branches-", QT_TR_NOOP("Prune short or thin branches…"), "Ctrl+P"},
        {Command::BridgeGap, "join-the-pieces-at-the-next-gap", QT_TR_NOOP("Bridge next gap"), "Ctrl+G"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::angiogramCommands()
{
    static constexpr CommandRow rows[]{
        {Command::EditVessels, "edit-traced-vessels", QT_TR_NOOP("Edit traced vessels"), "E", Switch},
        {Command::TraceAgain, "trace-this-frame-again", QT_TR_NOOP("Trace this frame again")},
        {Command::MeasureLength, "measure-a-length", QT_TR_NOOP("Measure length"), "Shift+D", Switch | StartsGroup},
        {Command::MeasureAngle, "measure-an-angle", QT_TR_NOOP("Measure angle"), "Shift+G", Switch},
        {Command::MeasureArea, "measure-an-area", QT_TR_NOOP("Measure area"), "Shift+O", Switch},
        {Command::TargetPoint, "set-a-check-point", QT_TR_NOOP("Add target point"), "Shift+X", Switch | StartsGroup},
        {Command::OstiumRing, "set-the-ring-of-an-ostium", QT_TR_NOOP("Add ostium ring"), "Shift+Q", Switch},
        {Command::TargetInImage, "say-where-a-check-point-is-seen", QT_TR_NOOP("Mark target point in image"), "Shift+S",
         Switch},
        {Command::DrawArrow, "draw-an-arrow", QT_TR_NOOP("Draw arrow"), "Shift+W", Switch},
        {Command::WriteText, "write-a-text-on-the-image", QT_TR_NOOP("Add text annotation"), "Shift+T", Switch},
        {Command::AddView, "add-a-view-", QT_TR_NOOP("Add view…"), "Ctrl+Shift+V", StartsGroup},
        {Command::NextView, "show-the-next-view", QT_TR_NOOP("Show next view"), "Ctrl+Tab"},
        {Command::SideBySide, "views-side-by-side", QT_TR_NOOP("Show views side by side"), "6", Switch},
        {Command::LinkedCrosshair, "cross-hair-through-views-side-by-side", QT_TR_NOOP("Linked crosshair across views"),
         "Z", Switch},
        {Command::Subtract, "subtract-mask-native", QT_TR_NOOP("Toggle DSA / native"), "B", Switch | StartsGroup},
        {Command::ShiftMask, "move-the-mask-by-hand", QT_TR_NOOP("Pixel shift"), "Shift+B", Switch},
        {Command::SetMaskFrame, "this-frame-is-the-mask", QT_TR_NOOP("Set as mask frame"), "Ctrl+B"},
        {Command::Composite, "whole-run-in-one-picture", QT_TR_NOOP("Peak-opacification image"), "Shift+C", Switch},
        {Command::Cine, "play-frames", QT_TR_NOOP("Play frames"), "C", Switch | StartsGroup},
        {Command::PlaySlower, "play-slower", QT_TR_NOOP("Play slower"), "Ctrl+,"},
        {Command::PlayFaster, "play-faster", QT_TR_NOOP("Play faster"), "Ctrl+."},
        {Command::PlayBackAndForth, "play-back-and-forth", QT_TR_NOOP("Play back and forth"), "", Switch},
        {Command::SetLoopStart, "play-from-this-frame-on", QT_TR_NOOP("Play from this frame"), "Ctrl+["},
        {Command::SetLoopEnd, "play-up-to-this-frame", QT_TR_NOOP("Play to this frame"), "Ctrl+]"},
        {Command::ClearLoop, "play-the-whole-run", QT_TR_NOOP("Play the entire run")},
        {Command::Opacification, "opacification-over-time", QT_TR_NOOP("Opacification over time"), "G"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::poseCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Nudge, "nudge-mode", QT_TR_NOOP("Nudge mode"), "N", Switch},
        {Command::PickPivot, "pick-the-point-to-turn-about", QT_TR_NOOP("Set rotation center"), "Shift+N", Switch},
        {Command::CentroidPivot, "turn-about-the-centroid-again", QT_TR_NOOP("Reset rotation center"), "Ctrl+Shift+N"},
        {Command::ResetPose, "back-to-start-pose", QT_TR_NOOP("Reset to initial pose"), "Backspace"},
        {Command::SetInitialPose, "this-pose-is-the-start-pose", QT_TR_NOOP("Set as initial pose"), "Shift+Backspace"},
        {Command::StartFromAngles, "start-pose-from-the-angles", QT_TR_NOOP("Set initial pose from angles"),
         "Ctrl+Backspace"},
        {Command::Landmarks, "click-pairs-of-landmarks", QT_TR_NOOP("Pick landmark pairs"), "L", Switch | StartsGroup},
        {Command::RegisterLandmarks, "place-vessels-by-landmarks", QT_TR_NOOP("Register from landmarks"), "Shift+L"},
        {Command::TakeSnapshot, "keep-this-pose", QT_TR_NOOP("Save pose snapshot"), "K", StartsGroup},
        {Command::ToggleSnapshots, "switch-between-poses-a-and-b", QT_TR_NOOP("Switch between poses A and B"), "Y"},
        {Command::ComparePoses, "compare-poses-and-methods-", QT_TR_NOOP("Compare poses and methods…"), "Shift+K"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::registrationCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Register, "register", QT_TR_NOOP("Register"), "R"},
        {Command::Stop, "stop-and-keep-the-best-pose", QT_TR_NOOP("Stop and keep the best pose"), "Shift+R"},
        {Command::TrackVessels, "follow-the-vessels-through-the-run", QT_TR_NOOP("Track vessels through the run"),
         "Shift+F"},
        {Command::NextSolution, "show-the-run-s-other-solutions", QT_TR_NOOP("Show alternative solutions"), "J",
         StartsGroup},
        {Command::AcceptSolution, "take-the-solution-shown", QT_TR_NOOP("Accept this solution"), "Shift+J"},
        {Command::ToggleAuxiliary, "selected-branches-auxiliary-on-or-off",
         QT_TR_NOOP("Toggle auxiliary for selected branches"), "A", StartsGroup},
        {Command::AuxiliaryInView, "auxiliary-the-branches-in-view", QT_TR_NOOP("Auxiliary: branches in view"), "V"},
        {Command::AuxiliaryLargeVessels, "auxiliary-the-wider-half", QT_TR_NOOP("Auxiliary: larger vessels"),
         "Shift+V"},
        {Command::Lasso, "auxiliary-draw-a-lasso", QT_TR_NOOP("Auxiliary: select with lasso"), "Ctrl+L", Switch},
        {Command::AuxiliaryAdvice, "auxiliary-which-branches-", QT_TR_NOOP("Choose auxiliary branches…"), "Shift+A"},
        {Command::ToggleExcluded, "exclude-or-include-selected-branches",
         QT_TR_NOOP("Exclude or include selected branches"), "X"},
        {Command::BlindTrial, "blind-observer-trial-", QT_TR_NOOP("Blind observer trial…"), "", StartsGroup},
        {Command::FinishTrial, "trial-done", QT_TR_NOOP("Finish trial"), "Ctrl+Return"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::viewCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Fit, "fit-the-image-to-the-window", QT_TR_NOOP("Fit image to window"), "1"},
        {Command::MirrorView, "seen-from-the-source-mirrored-", QT_TR_NOOP("Mirror view (source side)"), "Q", Switch},
        {Command::Outline, "vessels-centreline-outline-tube-radiograph",
         QT_TR_NOOP("Cycle vessel style (centerline / outline / tube / DRR)"), "O", StartsGroup},
        {Command::DepthCue, "near-vessels-bright-far-ones-dim", QT_TR_NOOP("Depth cueing"), "D", Switch},
        {Command::ShowTrace, "show-traced-vessels", QT_TR_NOOP("Show traced vessels"), "T", Switch},
        {Command::LessOpacity, "overlay-fainter", QT_TR_NOOP("Decrease overlay opacity"), "[", Repeats},
        {Command::MoreOpacity, "overlay-stronger", QT_TR_NOOP("Increase overlay opacity"), "]", Repeats},
        {Command::Swipe, "swipe-lens-off", QT_TR_NOOP("Cycle swipe / magic lens"), "S"},
        {Command::WorstBranch, "zoom-to-the-worst-branch-the-next", QT_TR_NOOP("Go to next worst branch"), "W"},
        {Command::DeformedVessels, "vessels-bent-where-that-is-known-or-rigid", QT_TR_NOOP("Show deformed vessels"),
         "Shift+Y", Switch},
        {Command::DeformationColors, "colours-how-far-bent-vessels-moved", QT_TR_NOOP("Color by deformation"),
         "Shift+M", Switch},
        {Command::Flicker, "flicker-start-pose-and-pose", QT_TR_NOOP("Flicker initial / current pose"), "F",
         Switch | StartsGroup},
        {Command::Replay, "replay-the-last-run", QT_TR_NOOP("Replay last registration"), "P", Switch},
        {Command::Swing, "swing-along-what-the-image-cannot-tell", QT_TR_NOOP("Animate pose uncertainty"), "U", Switch},
        {Command::GantryAngles, "c-arm-angles-for-the-branch-", QT_TR_NOOP("C-arm angles for branch…"), "Shift+U"},
        {Command::HideIdentity, "hide-patient-identity", QT_TR_NOOP("Hide patient identity"), "Shift+P",
         Switch | StartsGroup},
        {Command::ResetTreeView, "3-d-view-everything-the-vessels-alone", QT_TR_NOOP("3-D view: fit all / vessels"),
         "3", StartsGroup},
        {Command::ScanIn3d, "scan-in-the-3-d-view", QT_TR_NOOP("Show scan in 3-D view"), "Ctrl+3", Switch},
        {Command::NextScanRendering, "scan-in-3-d-vessels-vessels-and-bone",
         QT_TR_NOOP("3-D scan: vessels / vessels and bone"), "Ctrl+4"},
        {Command::ScanAtVessels, "scan-in-3-d-only-around-the-vessels", QT_TR_NOOP("3-D scan: only around vessels"),
         "Ctrl+5", Switch},
        {Command::ScanOnDetector, "radiograph-of-the-scan-on-the-detector", QT_TR_NOOP("Scan DRR on detector"),
         "Ctrl+6", Switch},
        {Command::NextCornerView, "3-d-axial-coronal-sagittal-below-the-branches", QT_TR_NOOP("Cycle lower-left view"),
         "2"},
        {Command::SlicesLarge, "slices-instead-of-the-angiogram", QT_TR_NOOP("Show scan slices"), "M", Switch},
        {Command::FullScreen, "full-screen", QT_TR_NOOP("Full screen"), "F11", Switch},
        {Command::ReduceMotion, "reduce-motion", QT_TR_NOOP("Reduce motion"), "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::brightnessCommands()
{
    static constexpr CommandRow rows[]{
        {Command::AutoWindow, "automatic-brightness", QT_TR_NOOP("Automatic window/level"), "0"},
        {Command::VesselWindow, "brightness-the-vessels-alone", QT_TR_NOOP("Window preset: vessels"), "Ctrl+0"},
        {Command::SoftWindow, "brightness-soft-with-bone-and-catheter", QT_TR_NOOP("Window preset: bone and devices"),
         "Ctrl+9"},
        {Command::FullRange, "brightness-every-grey-value", QT_TR_NOOP("Window preset: full range"), "9"},
        {Command::MoreContrast, "more-contrast", QT_TR_NOOP("More contrast"), "8", Repeats | StartsGroup},
        {Command::LessContrast, "less-contrast", QT_TR_NOOP("Less contrast"), "7", Repeats},
        {Command::Invert, "invert-grey-values", QT_TR_NOOP("Invert grayscale"), "I", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::colorCommands()
{
    static constexpr CommandRow rows[]{
        {Command::ColorsBlueAmber, "blue-to-amber", QT_TR_NOOP("Blue to amber"), "", Switch},
        {Command::ColorsBlueRed, "blue-white-red", QT_TR_NOOP("Blue, white, red"), "", Switch},
        {Command::ColorsBrightness, "brightness-alone", QT_TR_NOOP("Brightness only"), "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::layoutCommands()
{
    static constexpr CommandRow rows[]{
        {Command::ImageOnly, "image-alone-without-the-columns", QT_TR_NOOP("Angiogram only"), "4", Switch},
        {Command::CornerOnly, "3-d-and-slices-alone", QT_TR_NOOP("3-D and slices only"), "5", Switch},
        {Command::ImageWindow, "angiogram-in-a-window-of-its-own", QT_TR_NOOP("Angiogram in separate window"), "F7",
         Switch | StartsGroup},
        {Command::CornerWindow, "3-d-and-slices-in-a-window-of-their-own",
         QT_TR_NOOP("3-D and slices in separate window"), "F8", Switch},
        {Command::SlicesWindow, "all-slices-in-a-window-of-their-own", QT_TR_NOOP("All slices in separate window"),
         "F9", Switch},
        {Command::FoldLeft, "fold-the-left-column", QT_TR_NOOP("Collapse left panel"), "F5", Switch | StartsGroup},
        {Command::FoldRight, "fold-the-right-column", QT_TR_NOOP("Collapse right panel"), "F6", Switch},
        {Command::LayoutFollowsStep, "the-layout-follows-the-step", QT_TR_NOOP("Change layout with step"), "",
         Switch | StartsGroup},
        {Command::ResetLayout, "layout-of-this-step-as-it-came", QT_TR_NOOP("Reset layout for this step"), "Shift+F5"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::themeCommands()
{
    static constexpr CommandRow rows[]{
        {Command::ThemeDark, "dark", QT_TR_NOOP("Dark"), "", Switch},
        {Command::ThemeLight, "light", QT_TR_NOOP("Light"), "", Switch},
        {Command::ThemeSystem, "as-the-desktop", QT_TR_NOOP("System theme"), "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::languageCommands()
{
    static constexpr CommandRow rows[]{
        {Command::LanguageSystem, "language-of-the-desktop", QT_TR_NOOP("System language"), "", Switch},
        {Command::LanguageEnglish, "english", "English", "", Switch},
        {Command::LanguageGerman, "deutsch", "Deutsch", "", Switch},
        {Command::LanguageChinese, "-", "简体中文", "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::mouseCommands()
{
    static constexpr CommandRow rows[]{
        {Command::MouseRadiology, "radiology-left-drag-windows",
         QT_TR_NOOP("Radiology: left-drag adjusts window/level"), "", Switch},
        {Command::MouseSlicer, "3d-slicer-left-only-picks", QT_TR_NOOP("3D Slicer: left button only selects"), "",
         Switch},
        {Command::MouseScroll, "scroll-left-drag-runs-the-frames",
         QT_TR_NOOP("Scroll: left-drag scrolls through frames"), "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::helpCommands()
{
    static constexpr CommandRow rows[]{
        {Command::PanelHelp, "help-on-what-the-mouse-points-at", QT_TR_NOOP("Context help"), "F1"},
        {Command::Tour, "short-tour", QT_TR_NOOP("Quick tour")},
        {Command::GoodFit, "what-a-good-fit-looks-like", QT_TR_NOOP("Examples of good and bad fits"), "Shift+F1"},
        {Command::Keys, "keys-and-mouse", QT_TR_NOOP("Keyboard and mouse"), "?; Ctrl+F1", StartsGroup},
        {Command::Messages, "messages", QT_TR_NOOP("Messages"), "Ctrl+Shift+M"},
        {Command::SupportBundle, "save-support-bundle-", QT_TR_NOOP("Save support bundle…")},
        {Command::About, "about-angiopose", QT_TR_NOOP("About AngioPose")},
    };
    return rows;
}

std::span<const MenuRows> CommandTable::menus()
{
    static const std::array table{
        MenuRows{Menu::File, QT_TR_NOOP("&File"), fileCommands()},
        MenuRows{Menu::Exports, QT_TR_NOOP("Export"), exportCommands()},
        MenuRows{Menu::Edit, QT_TR_NOOP("&Edit"), editCommands()},
        MenuRows{Menu::Vessels, QT_TR_NOOP("Ve&ssels"), vesselsCommands()},
        MenuRows{Menu::Angiogram, QT_TR_NOOP("&Angiogram"), angiogramCommands()},
        MenuRows{Menu::Pose, QT_TR_NOOP("&Pose"), poseCommands()},
        MenuRows{Menu::Registration, QT_TR_NOOP("&Registration"), registrationCommands()},
        MenuRows{Menu::View, QT_TR_NOOP("&View"), viewCommands()},
        MenuRows{Menu::Brightness, QT_TR_NOOP("Window/level"), brightnessCommands()},
        MenuRows{Menu::Places, QT_TR_NOOP("Layout"), layoutCommands()},
        MenuRows{Menu::Colors, QT_TR_NOOP("Vessel and residual colors"), colorCommands()},
        MenuRows{Menu::Theme, QT_TR_NOOP("Theme"), themeCommands()},
        MenuRows{Menu::Language, QT_TR_NOOP("Language"), languageCommands()},
        MenuRows{Menu::Mouse, QT_TR_NOOP("Mouse"), mouseCommands()},
        MenuRows{Menu::Help, QT_TR_NOOP("&Help"), helpCommands()},
    };
    return table;
}

}   // namespace angiopose::ui
