#include "ui/actions/command_table.h"

#include <array>

namespace angiopose::ui {

std::span<const CommandRow> CommandTable::fileCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Open, "open-", QT_TR_NOOP("Open …"), "Ctrl+O"},
        {Command::OpenFolder, "open-folder-or-disc-", QT_TR_NOOP("Open folder or disc …"), "Ctrl+Shift+O"},
        {Command::OpenArchive, "open-from-archive-", QT_TR_NOOP("Open from archive …"), "Ctrl+Shift+A"},
        {Command::OpenSample, "open-sample-case", QT_TR_NOOP("Open sample case")},
        {Command::NewWindow, "new-window", QT_TR_NOOP("New window"), "Ctrl+N"},
        {Command::Save, "save", QT_TR_NOOP("Save"), "Ctrl+S", StartsGroup},
        {Command::SaveAs, "save-as-", QT_TR_NOOP("Save as …"), "Ctrl+Shift+S"},
        {Command::ExportOverlay, "export-overlay-", QT_TR_NOOP("Export overlay …"), "Ctrl+E"},
        {Command::SendToArchive, "send-to-archive-", QT_TR_NOOP("Send to archive …"), "", StartsGroup},
        {Command::PackCase, "pack-case-for-others-", QT_TR_NOOP("Pack case for others …")},
        {Command::DeidentifyFiles, "de-identify-files-", QT_TR_NOOP("De-identify files …")},
        {Command::SaveWindow, "save-picture-of-the-window-", QT_TR_NOOP("Save picture of the window …"), "F12"},
        {Command::PrivateMode, "private-mode", QT_TR_NOOP("Private mode"), "", Switch | StartsGroup},
        {Command::KeepAudit, "keep-an-audit-file-", QT_TR_NOOP("Keep an audit file …"), "", Switch},
        {Command::CloseCase, "close-case", QT_TR_NOOP("Close case"), "Ctrl+W", StartsGroup},
        {Command::Close, "quit", QT_TR_NOOP("Quit"), "Ctrl+Q"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::exportCommands()
{
    static constexpr CommandRow rows[]{
        {Command::ExportMovie, "export-movie-", QT_TR_NOOP("Export movie …"), "Ctrl+Shift+E"},
        {Command::ExportReport, "export-report-", QT_TR_NOOP("Export report …")},
        {Command::ExportDicom, "export-dicom-objects-", QT_TR_NOOP("Export DICOM objects …")},
        {Command::ExportResult, "export-result-", QT_TR_NOOP("Export result …")},
        {Command::ExportPose, "export-pose-", QT_TR_NOOP("Export pose …")},
        {Command::ExportTrace, "export-traced-vessels-", QT_TR_NOOP("Export traced vessels …")},
        {Command::ExportVessels, "export-vessel-tree-", QT_TR_NOOP("Export vessel tree …")},
        {Command::ExportMask, "export-lumen-mask-", QT_TR_NOOP("Export lumen mask …")},
        {Command::ExportDeformed, "export-bent-vessels-", QT_TR_NOOP("Export bent vessels …")},
        {Command::ExportFollowed, "export-followed-poses-", QT_TR_NOOP("Export followed poses …")},
        {Command::ExportMeasurements, "export-measurements-", QT_TR_NOOP("Export measurements …")},
        {Command::ExportCheckPoints, "export-check-points-", QT_TR_NOOP("Export check points …")},
        {Command::ExportBranches, "export-measures-of-the-branches-", QT_TR_NOOP("Export measures of the branches …")},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::editCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Undo, "undo", QT_TR_NOOP("Undo"), "Ctrl+Z", Repeats},
        {Command::Redo, "redo", QT_TR_NOOP("Redo"), "Ctrl+Shift+Z; Ctrl+Y", Repeats},
        {Command::CopyPose, "copy-pose-as-matrix", QT_TR_NOOP("Copy pose as matrix"), "Ctrl+C", StartsGroup},
        {Command::CopyWindow, "copy-picture-of-the-window", QT_TR_NOOP("Copy picture of the window"), "Ctrl+Shift+C"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::vesselsCommands()
{
    static constexpr CommandRow rows[]{
        {Command::TraceScan, "trace-the-scan-again", QT_TR_NOOP("Trace the scan again"), "Ctrl+T"},
        {Command::TraceBetween, "trace-one-vessel-between-two-places",
         QT_TR_NOOP("Trace one vessel between two places"), "Ctrl+I", Switch},
        {Command::ChooseLabels, "choose-the-labels-that-are-vessels", QT_TR_NOOP("Choose the labels that are vessels"),
         "Ctrl+Shift+T"},
        {Command::PaintMask, "paint-into-the-lumen-mask", QT_TR_NOOP("Paint into the lumen mask"), "Ctrl+D",
         Switch | StartsGroup},
        {Command::EraseMask, "erase-from-the-lumen-mask", QT_TR_NOOP("Erase from the lumen mask"), "Ctrl+R", Switch},
        {Command::CutMask, "cut-the-lumen-mask-by-a-lasso", QT_TR_NOOP("Cut the lumen mask by a lasso"), "Ctrl+X",
         Switch},
        {Command::TraceMask, "trace-the-edited-mask", QT_TR_NOOP("Trace the edited mask"), "Ctrl+U"},
        {Command::FindBranch, "find-a-branch", QT_TR_NOOP("Find a branch"), "Ctrl+F", StartsGroup},
        {Command::SelectAll, "select-all-branches", QT_TR_NOOP("Select all branches"), "Ctrl+A"},
        {Command::RenameBranch, "rename-branch", QT_TR_NOOP("Rename branch"), "F2"},
        {Command::CutBranch, "cut-branch-at-the-cross-hair", QT_TR_NOOP("Cut branch at the cross-hair"), "Ctrl+K"},
        {Command::JoinBranches, "join-two-branches", QT_TR_NOOP("Join two branches"), "Ctrl+J"},
        {Command::SmoothBranches, "smooth-branches", QT_TR_NOOP("Smooth branches"), "Ctrl+M"},
        {Command::RootAtBranch, "root-at-the-branch-s-end-near-the-cross-hair",
         QT_TR_NOOP("Root at the branch's end near the cross-hair"), "Ctrl+Home"},
        {Command::HideBranches, "hide-or-show-branches", QT_TR_NOOP("Hide or show branches"), "Shift+H", StartsGroup},
        {Command::ShowAllBranches, "show-all-branches", QT_TR_NOOP("Show all branches"), "Ctrl+Shift+H"},
        {Command::DeleteBranches, "delete-branches", QT_TR_NOOP("Delete branches"), "Delete", StartsGroup},
        {Command::DeleteSubtrees, "delete-branches-and-what-leaves-them",
         QT_TR_NOOP("Delete branches and what leaves them"), "Shift+Delete"},
        {Command::PruneTree, "prune-short-or-thin-branches-", QT_TR_NOOP("Prune short or thin branches …"), "Ctrl+P"},
        {Command::MendGap, "join-the-pieces-at-the-next-gap", QT_TR_NOOP("Join the pieces at the next gap"), "Ctrl+G"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::angiogramCommands()
{
    static constexpr CommandRow rows[]{
        {Command::EditVessels, "edit-traced-vessels", QT_TR_NOOP("Edit traced vessels"), "E", Switch},
        {Command::TraceAgain, "trace-this-frame-again", QT_TR_NOOP("Trace this frame again")},
        {Command::MeasureLength, "measure-a-length", QT_TR_NOOP("Measure a length"), "Shift+D", Switch | StartsGroup},
        {Command::MeasureAngle, "measure-an-angle", QT_TR_NOOP("Measure an angle"), "Shift+G", Switch},
        {Command::MeasureArea, "measure-an-area", QT_TR_NOOP("Measure an area"), "Shift+O", Switch},
        {Command::CheckPoint, "set-a-check-point", QT_TR_NOOP("Set a check point"), "Shift+X", Switch | StartsGroup},
        {Command::OstiumRing, "set-the-ring-of-an-ostium", QT_TR_NOOP("Set the ring of an ostium"), "Shift+Q", Switch},
        {Command::SeenHere, "say-where-a-check-point-is-seen", QT_TR_NOOP("Say where a check point is seen"), "Shift+S",
         Switch},
        {Command::DrawArrow, "draw-an-arrow", QT_TR_NOOP("Draw an arrow"), "Shift+W", Switch},
        {Command::WriteText, "write-a-text-on-the-image", QT_TR_NOOP("Write a text on the image"), "Shift+T", Switch},
        {Command::AddView, "add-a-view-", QT_TR_NOOP("Add a view …"), "Ctrl+Shift+V", StartsGroup},
        {Command::NextView, "show-the-next-view", QT_TR_NOOP("Show the next view"), "Ctrl+Tab"},
        {Command::SideBySide, "views-side-by-side", QT_TR_NOOP("Views side by side"), "6", Switch},
        {Command::LinkedCrosshair, "cross-hair-through-views-side-by-side",
         QT_TR_NOOP("Cross-hair through views side by side"), "Z", Switch},
        {Command::Subtract, "subtract-mask-native", QT_TR_NOOP("Subtract mask, native"), "B", Switch | StartsGroup},
        {Command::ShiftMask, "move-the-mask-by-hand", QT_TR_NOOP("Move the mask by hand"), "Shift+B", Switch},
        {Command::MaskHere, "this-frame-is-the-mask", QT_TR_NOOP("This frame is the mask"), "Ctrl+B"},
        {Command::Composite, "whole-run-in-one-picture", QT_TR_NOOP("Whole run in one picture"), "Shift+C", Switch},
        {Command::Cine, "play-frames", QT_TR_NOOP("Play frames"), "C", Switch | StartsGroup},
        {Command::PlaySlower, "play-slower", QT_TR_NOOP("Play slower"), "Ctrl+,"},
        {Command::PlayFaster, "play-faster", QT_TR_NOOP("Play faster"), "Ctrl+."},
        {Command::PlayBackAndForth, "play-back-and-forth", QT_TR_NOOP("Play back and forth"), "", Switch},
        {Command::LoopFromHere, "play-from-this-frame-on", QT_TR_NOOP("Play from this frame on"), "Ctrl+["},
        {Command::LoopToHere, "play-up-to-this-frame", QT_TR_NOOP("Play up to this frame"), "Ctrl+]"},
        {Command::LoopWholeRun, "play-the-whole-run", QT_TR_NOOP("Play the whole run")},
        {Command::Opacification, "opacification-over-time", QT_TR_NOOP("Opacification over time"), "G"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::poseCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Nudge, "nudge-mode", QT_TR_NOOP("Nudge mode"), "N", Switch},
        {Command::PickPivot, "pick-the-point-to-turn-about", QT_TR_NOOP("Pick the point to turn about"), "Shift+N",
         Switch},
        {Command::CentroidPivot, "turn-about-the-centroid-again", QT_TR_NOOP("Turn about the centroid again"),
         "Ctrl+Shift+N"},
        {Command::ResetPose, "back-to-start-pose", QT_TR_NOOP("Back to start pose"), "Backspace"},
        {Command::StartHere, "this-pose-is-the-start-pose", QT_TR_NOOP("This pose is the start pose"),
         "Shift+Backspace"},
        {Command::StartFromAngles, "start-pose-from-the-angles", QT_TR_NOOP("Start pose from the angles"),
         "Ctrl+Backspace"},
        {Command::Landmarks, "click-pairs-of-landmarks", QT_TR_NOOP("Click pairs of landmarks"), "L",
         Switch | StartsGroup},
        {Command::PlaceByLandmarks, "place-vessels-by-landmarks", QT_TR_NOOP("Place vessels by landmarks"), "Shift+L"},
        {Command::KeepPose, "keep-this-pose", QT_TR_NOOP("Keep this pose"), "K", StartsGroup},
        {Command::SwitchPoses, "switch-between-poses-a-and-b", QT_TR_NOOP("Switch between poses A and B"), "Y"},
        {Command::ComparePoses, "compare-poses-and-methods-", QT_TR_NOOP("Compare poses and methods …"), "Shift+K"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::registrationCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Register, "register", QT_TR_NOOP("Register"), "R"},
        {Command::Stop, "stop-and-keep-the-best-pose", QT_TR_NOOP("Stop and keep the best pose"), "Shift+R"},
        {Command::FollowFrames, "follow-the-vessels-through-the-run", QT_TR_NOOP("Follow the vessels through the run"),
         "Shift+F"},
        {Command::NextSolution, "show-the-run-s-other-solutions", QT_TR_NOOP("Show the run's other solutions"), "J",
         StartsGroup},
        {Command::TakeSolution, "take-the-solution-shown", QT_TR_NOOP("Take the solution shown"), "Shift+J"},
        {Command::ToggleAuxiliary, "selected-branches-auxiliary-on-or-off",
         QT_TR_NOOP("Selected branches auxiliary on or off"), "A", StartsGroup},
        {Command::AuxiliaryInView, "auxiliary-the-branches-in-view", QT_TR_NOOP("Auxiliary: the branches in view"),
         "V"},
        {Command::AuxiliaryWide, "auxiliary-the-wider-half", QT_TR_NOOP("Auxiliary: the wider half"), "Shift+V"},
        {Command::Lasso, "auxiliary-draw-a-lasso", QT_TR_NOOP("Auxiliary: draw a lasso"), "Ctrl+L", Switch},
        {Command::AuxiliaryAdvice, "auxiliary-which-branches-", QT_TR_NOOP("Auxiliary: which branches …"), "Shift+A"},
        {Command::ToggleExcluded, "exclude-or-include-selected-branches",
         QT_TR_NOOP("Exclude or include selected branches"), "X"},
        {Command::BlindTrial, "blind-observer-trial-", QT_TR_NOOP("Blind observer trial …"), "", StartsGroup},
        {Command::TrialDone, "trial-done", QT_TR_NOOP("Trial done"), "Ctrl+Return"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::viewCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Fit, "fit-the-image-to-the-window", QT_TR_NOOP("Fit the image to the window"), "1"},
        {Command::FromSource, "seen-from-the-source-mirrored-", QT_TR_NOOP("Seen from the source (mirrored)"), "Q",
         Switch},
        {Command::Outline, "vessels-centreline-outline-tube-radiograph",
         QT_TR_NOOP("Vessels: centreline, outline, tube, radiograph"), "O", StartsGroup},
        {Command::DepthCue, "near-vessels-bright-far-ones-dim", QT_TR_NOOP("Near vessels bright, far ones dim"), "D",
         Switch},
        {Command::ShowTrace, "show-traced-vessels", QT_TR_NOOP("Show traced vessels"), "T", Switch},
        {Command::LessOpacity, "overlay-fainter", QT_TR_NOOP("Overlay fainter"), "[", Repeats},
        {Command::MoreOpacity, "overlay-stronger", QT_TR_NOOP("Overlay stronger"), "]", Repeats},
        {Command::Swipe, "swipe-lens-off", QT_TR_NOOP("Swipe, lens, off"), "S"},
        {Command::WorstBranch, "zoom-to-the-worst-branch-the-next", QT_TR_NOOP("Zoom to the worst branch, the next"),
         "W"},
        {Command::DeformedVessels, "vessels-bent-where-that-is-known-or-rigid",
         QT_TR_NOOP("Vessels bent, where that is known, or rigid"), "Shift+Y", Switch},
        {Command::MotionColors, "colours-how-far-bent-vessels-moved", QT_TR_NOOP("Colours: how far bent vessels moved"),
         "Shift+M", Switch},
        {Command::Flicker, "flicker-start-pose-and-pose", QT_TR_NOOP("Flicker start pose and pose"), "F",
         Switch | StartsGroup},
        {Command::Replay, "replay-the-last-run", QT_TR_NOOP("Replay the last run"), "P", Switch},
        {Command::Swing, "swing-along-what-the-image-cannot-tell", QT_TR_NOOP("Swing along what the image cannot tell"),
         "U", Switch},
        {Command::GantryAngles, "c-arm-angles-for-the-branch-", QT_TR_NOOP("C-arm angles for the branch …"), "Shift+U"},
        {Command::HideIdentity, "hide-patient-identity", QT_TR_NOOP("Hide patient identity"), "Shift+P",
         Switch | StartsGroup},
        {Command::ResetTreeView, "3-d-view-everything-the-vessels-alone",
         QT_TR_NOOP("3-D view: everything, the vessels alone"), "3", StartsGroup},
        {Command::ScanIn3d, "scan-in-the-3-d-view", QT_TR_NOOP("Scan in the 3-D view"), "Ctrl+3", Switch},
        {Command::NextScanLook, "scan-in-3-d-vessels-vessels-and-bone",
         QT_TR_NOOP("Scan in 3-D: vessels, vessels and bone"), "Ctrl+4"},
        {Command::ScanAtVessels, "scan-in-3-d-only-around-the-vessels",
         QT_TR_NOOP("Scan in 3-D: only around the vessels"), "Ctrl+5", Switch},
        {Command::ScanOnDetector, "radiograph-of-the-scan-on-the-detector",
         QT_TR_NOOP("Radiograph of the scan on the detector"), "Ctrl+6", Switch},
        {Command::NextCornerView, "3-d-axial-coronal-sagittal-below-the-branches",
         QT_TR_NOOP("3-D, axial, coronal, sagittal below the branches"), "2"},
        {Command::SlicesLarge, "slices-instead-of-the-angiogram", QT_TR_NOOP("Slices instead of the angiogram"), "M",
         Switch},
        {Command::FullScreen, "full-screen", QT_TR_NOOP("Full screen"), "F11", Switch},
        {Command::ReduceMotion, "reduce-motion", QT_TR_NOOP("Reduce motion"), "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::brightnessCommands()
{
    static constexpr CommandRow rows[]{
        {Command::AutoWindow, "automatic-brightness", QT_TR_NOOP("Automatic brightness"), "0"},
        {Command::VesselWindow, "brightness-the-vessels-alone", QT_TR_NOOP("Brightness: the vessels alone"), "Ctrl+0"},
        {Command::SoftWindow, "brightness-soft-with-bone-and-catheter",
         QT_TR_NOOP("Brightness: soft, with bone and catheter"), "Ctrl+9"},
        {Command::FullRange, "brightness-every-grey-value", QT_TR_NOOP("Brightness: every grey value"), "9"},
        {Command::MoreContrast, "more-contrast", QT_TR_NOOP("More contrast"), "8", Repeats | StartsGroup},
        {Command::LessContrast, "less-contrast", QT_TR_NOOP("Less contrast"), "7", Repeats},
        {Command::Invert, "invert-grey-values", QT_TR_NOOP("Invert grey values"), "I", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::colorCommands()
{
    static constexpr CommandRow rows[]{
        {Command::ColorsBlueAmber, "blue-to-amber", QT_TR_NOOP("Blue to amber"), "", Switch},
        {Command::ColorsBlueRed, "blue-white-red", QT_TR_NOOP("Blue, white, red"), "", Switch},
        {Command::ColorsBrightness, "brightness-alone", QT_TR_NOOP("Brightness alone"), "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::placesCommands()
{
    static constexpr CommandRow rows[]{
        {Command::ImageOnly, "image-alone-without-the-columns", QT_TR_NOOP("Image alone, without the columns"), "4",
         Switch},
        {Command::CornerOnly, "3-d-and-slices-alone", QT_TR_NOOP("3-D and slices alone"), "5", Switch},
        {Command::ImageWindow, "angiogram-in-a-window-of-its-own", QT_TR_NOOP("Angiogram in a window of its own"), "F7",
         Switch | StartsGroup},
        {Command::CornerWindow, "3-d-and-slices-in-a-window-of-their-own",
         QT_TR_NOOP("3-D and slices in a window of their own"), "F8", Switch},
        {Command::SlicesWindow, "all-slices-in-a-window-of-their-own",
         QT_TR_NOOP("All slices in a window of their own"), "F9", Switch},
        {Command::FoldLeft, "fold-the-left-column", QT_TR_NOOP("Fold the left column"), "F5", Switch | StartsGroup},
        {Command::FoldRight, "fold-the-right-column", QT_TR_NOOP("Fold the right column"), "F6", Switch},
        {Command::LayoutFollowsStep, "the-layout-follows-the-step", QT_TR_NOOP("The layout follows the step"), "",
         Switch | StartsGroup},
        {Command::ResetLayout, "layout-of-this-step-as-it-came", QT_TR_NOOP("Layout of this step as it came"),
         "Shift+F5"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::themeCommands()
{
    static constexpr CommandRow rows[]{
        {Command::ThemeDark, "dark", QT_TR_NOOP("Dark"), "", Switch},
        {Command::ThemeLight, "light", QT_TR_NOOP("Light"), "", Switch},
        {Command::ThemeSystem, "as-the-desktop", QT_TR_NOOP("As the desktop"), "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::languageCommands()
{
    static constexpr CommandRow rows[]{
        {Command::LanguageSystem, "language-of-the-desktop", QT_TR_NOOP("Language of the desktop"), "", Switch},
        {Command::LanguageEnglish, "english", "English", "", Switch},
        {Command::LanguageGerman, "deutsch", "Deutsch", "", Switch},
        {Command::LanguageChinese, "-", "简体中文", "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::mouseCommands()
{
    static constexpr CommandRow rows[]{
        {Command::MouseRadiology, "radiology-left-drag-windows", QT_TR_NOOP("Radiology: left drag windows"), "",
         Switch},
        {Command::MouseSlicer, "3d-slicer-left-only-picks", QT_TR_NOOP("3D Slicer: left only picks"), "", Switch},
        {Command::MouseScroll, "scroll-left-drag-runs-the-frames", QT_TR_NOOP("Scroll: left drag runs the frames"), "",
         Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::helpCommands()
{
    static constexpr CommandRow rows[]{
        {Command::PanelHelp, "help-on-what-the-mouse-points-at", QT_TR_NOOP("Help on what the mouse points at"), "F1"},
        {Command::Tour, "short-tour", QT_TR_NOOP("Short tour")},
        {Command::GoodFit, "what-a-good-fit-looks-like", QT_TR_NOOP("What a good fit looks like"), "Shift+F1"},
        {Command::Keys, "keys-and-mouse", QT_TR_NOOP("Keys and mouse"), "?; Ctrl+F1", StartsGroup},
        {Command::Messages, "messages", QT_TR_NOOP("Messages"), "Ctrl+Shift+M"},
        {Command::SupportBundle, "save-support-bundle-", QT_TR_NOOP("Save support bundle …")},
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
        MenuRows{Menu::Brightness, QT_TR_NOOP("Brightness"), brightnessCommands()},
        MenuRows{Menu::Places, QT_TR_NOOP("Views alone and in windows"), placesCommands()},
        MenuRows{Menu::Colors, QT_TR_NOOP("Colours of vessels and residuals"), colorCommands()},
        MenuRows{Menu::Theme, QT_TR_NOOP("Theme"), themeCommands()},
        MenuRows{Menu::Language, QT_TR_NOOP("Language"), languageCommands()},
        MenuRows{Menu::Mouse, QT_TR_NOOP("Mouse"), mouseCommands()},
        MenuRows{Menu::Help, QT_TR_NOOP("&Help"), helpCommands()},
    };
    return table;
}

}   // namespace angiopose::ui