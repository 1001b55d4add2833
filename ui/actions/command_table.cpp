#include "ui/actions/command_table.h"

#include <QRegularExpression>

#include <array>

namespace angiopose::ui {

QString CommandRow::name() const
{
    static const QRegularExpression rest(QStringLiteral("[^a-z0-9]+"));
    return QString::fromUtf8(text).toLower().replace(rest, QStringLiteral("-"));
}

std::span<const CommandRow> CommandTable::fileCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Open, QT_TR_NOOP("Open …"), "Ctrl+O"},
        {Command::OpenFolder, QT_TR_NOOP("Open folder or disc …"), "Ctrl+Shift+O"},
        {Command::OpenArchive, QT_TR_NOOP("Open from archive …"), "Ctrl+Shift+A"},
        {Command::OpenSample, QT_TR_NOOP("Open sample case")},
        {Command::NewWindow, QT_TR_NOOP("New window"), "Ctrl+N"},
        {Command::Save, QT_TR_NOOP("Save"), "Ctrl+S", StartsGroup},
        {Command::SaveAs, QT_TR_NOOP("Save as …"), "Ctrl+Shift+S"},
        {Command::ExportOverlay, QT_TR_NOOP("Export overlay …"), "Ctrl+E"},
        {Command::SendToArchive, QT_TR_NOOP("Send to archive …"), "", StartsGroup},
        {Command::PackCase, QT_TR_NOOP("Pack case for others …")},
        {Command::DeidentifyFiles, QT_TR_NOOP("De-identify files …")},
        {Command::SaveWindow, QT_TR_NOOP("Save picture of the window …"), "F12"},
        {Command::PrivateMode, QT_TR_NOOP("Private mode"), "", Switch | StartsGroup},
        {Command::KeepAudit, QT_TR_NOOP("Keep an audit file …"), "", Switch},
        {Command::CloseCase, QT_TR_NOOP("Close case"), "Ctrl+W", StartsGroup},
        {Command::Close, QT_TR_NOOP("Quit"), "Ctrl+Q"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::exportCommands()
{
    static constexpr CommandRow rows[]{
        {Command::ExportMovie, QT_TR_NOOP("Export movie …"), "Ctrl+Shift+E"},
        {Command::ExportReport, QT_TR_NOOP("Export report …")},
        {Command::ExportDicom, QT_TR_NOOP("Export DICOM objects …")},
        {Command::ExportResult, QT_TR_NOOP("Export result …")},
        {Command::ExportPose, QT_TR_NOOP("Export pose …")},
        {Command::ExportTrace, QT_TR_NOOP("Export traced vessels …")},
        {Command::ExportVessels, QT_TR_NOOP("Export vessel tree …")},
        {Command::ExportMask, QT_TR_NOOP("Export lumen mask …")},
        {Command::ExportDeformed, QT_TR_NOOP("Export bent vessels …")},
        {Command::ExportFollowed, QT_TR_NOOP("Export followed poses …")},
        {Command::ExportMeasurements, QT_TR_NOOP("Export measurements …")},
        {Command::ExportCheckPoints, QT_TR_NOOP("Export check points …")},
        {Command::ExportBranches, QT_TR_NOOP("Export measures of the branches …")},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::editCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Undo, QT_TR_NOOP("Undo"), "Ctrl+Z", Repeats},
        {Command::Redo, QT_TR_NOOP("Redo"), "Ctrl+Shift+Z; Ctrl+Y", Repeats},
        {Command::CopyPose, QT_TR_NOOP("Copy pose as matrix"), "Ctrl+C", StartsGroup},
        {Command::CopyWindow, QT_TR_NOOP("Copy picture of the window"), "Ctrl+Shift+C"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::vesselsCommands()
{
    static constexpr CommandRow rows[]{
        {Command::TraceScan, QT_TR_NOOP("Trace the scan again"), "Ctrl+T"},
        {Command::TraceBetween, QT_TR_NOOP("Trace one vessel between two places"), "Ctrl+I", Switch},
        {Command::ChooseLabels, QT_TR_NOOP("Choose the labels that are vessels"), "Ctrl+Shift+T"},
        {Command::PaintMask, QT_TR_NOOP("Paint into the lumen mask"), "Ctrl+D", Switch | StartsGroup},
        {Command::EraseMask, QT_TR_NOOP("Erase from the lumen mask"), "Ctrl+R", Switch},
        {Command::CutMask, QT_TR_NOOP("Cut the lumen mask by a lasso"), "Ctrl+X", Switch},
        {Command::TraceMask, QT_TR_NOOP("Trace the edited mask"), "Ctrl+U"},
        {Command::FindBranch, QT_TR_NOOP("Find a branch"), "Ctrl+F", StartsGroup},
        {Command::SelectAll, QT_TR_NOOP("Select all branches"), "Ctrl+A"},
        {Command::RenameBranch, QT_TR_NOOP("Rename branch"), "F2"},
        {Command::CutBranch, QT_TR_NOOP("Cut branch at the cross-hair"), "Ctrl+K"},
        {Command::JoinBranches, QT_TR_NOOP("Join two branches"), "Ctrl+J"},
        {Command::SmoothBranches, QT_TR_NOOP("Smooth branches"), "Ctrl+M"},
        {Command::RootAtBranch, QT_TR_NOOP("Root at the branch's end near the cross-hair"), "Ctrl+Home"},
        {Command::HideBranches, QT_TR_NOOP("Hide or show branches"), "Shift+H", StartsGroup},
        {Command::ShowAllBranches, QT_TR_NOOP("Show all branches"), "Ctrl+Shift+H"},
        {Command::DeleteBranches, QT_TR_NOOP("Delete branches"), "Delete", StartsGroup},
        {Command::DeleteSubtrees, QT_TR_NOOP("Delete branches and what leaves them"), "Shift+Delete"},
        {Command::PruneTree, QT_TR_NOOP("Prune short or thin branches …"), "Ctrl+P"},
        {Command::MendGap, QT_TR_NOOP("Join the pieces at the next gap"), "Ctrl+G"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::angiogramCommands()
{
    static constexpr CommandRow rows[]{
        {Command::EditVessels, QT_TR_NOOP("Edit traced vessels"), "E", Switch},
        {Command::TraceAgain, QT_TR_NOOP("Trace this frame again")},
        {Command::MeasureLength, QT_TR_NOOP("Measure a length"), "Shift+D", Switch | StartsGroup},
        {Command::MeasureAngle, QT_TR_NOOP("Measure an angle"), "Shift+G", Switch},
        {Command::MeasureArea, QT_TR_NOOP("Measure an area"), "Shift+O", Switch},
        {Command::CheckPoint, QT_TR_NOOP("Set a check point"), "Shift+X", Switch | StartsGroup},
        {Command::OstiumRing, QT_TR_NOOP("Set the ring of an ostium"), "Shift+Q", Switch},
        {Command::SeenHere, QT_TR_NOOP("Say where a check point is seen"), "Shift+S", Switch},
        {Command::DrawArrow, QT_TR_NOOP("Draw an arrow"), "Shift+W", Switch},
        {Command::WriteText, QT_TR_NOOP("Write a text on the image"), "Shift+T", Switch},
        {Command::AddView, QT_TR_NOOP("Add a view …"), "Ctrl+Shift+V", StartsGroup},
        {Command::NextView, QT_TR_NOOP("Show the next view"), "Ctrl+Tab"},
        {Command::SideBySide, QT_TR_NOOP("Views side by side"), "6", Switch},
        {Command::LinkedCrosshair, QT_TR_NOOP("Cross-hair through views side by side"), "Z", Switch},
        {Command::Subtract, QT_TR_NOOP("Subtract mask, native"), "B", Switch | StartsGroup},
        {Command::ShiftMask, QT_TR_NOOP("Move the mask by hand"), "Shift+B", Switch},
        {Command::MaskHere, QT_TR_NOOP("This frame is the mask"), "Ctrl+B"},
        {Command::Composite, QT_TR_NOOP("Whole run in one picture"), "Shift+C", Switch},
        {Command::Cine, QT_TR_NOOP("Play frames"), "C", Switch | StartsGroup},
        {Command::PlaySlower, QT_TR_NOOP("Play slower"), "Ctrl+,"},
        {Command::PlayFaster, QT_TR_NOOP("Play faster"), "Ctrl+."},
        {Command::PlayBackAndForth, QT_TR_NOOP("Play back and forth"), "", Switch},
        {Command::LoopFromHere, QT_TR_NOOP("Play from this frame on"), "Ctrl+["},
        {Command::LoopToHere, QT_TR_NOOP("Play up to this frame"), "Ctrl+]"},
        {Command::LoopWholeRun, QT_TR_NOOP("Play the whole run")},
        {Command::Opacification, QT_TR_NOOP("Opacification over time"), "G"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::poseCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Nudge, QT_TR_NOOP("Nudge mode"), "N", Switch},
        {Command::PickPivot, QT_TR_NOOP("Pick the point to turn about"), "Shift+N", Switch},
        {Command::CentroidPivot, QT_TR_NOOP("Turn about the centroid again"), "Ctrl+Shift+N"},
        {Command::ResetPose, QT_TR_NOOP("Back to start pose"), "Backspace"},
        {Command::StartHere, QT_TR_NOOP("This pose is the start pose"), "Shift+Backspace"},
        {Command::StartFromAngles, QT_TR_NOOP("Start pose from the angles"), "Ctrl+Backspace"},
        {Command::Landmarks, QT_TR_NOOP("Click pairs of landmarks"), "L", Switch | StartsGroup},
        {Command::PlaceByLandmarks, QT_TR_NOOP("Place vessels by landmarks"), "Shift+L"},
        {Command::KeepPose, QT_TR_NOOP("Keep this pose"), "K", StartsGroup},
        {Command::SwitchPoses, QT_TR_NOOP("Switch between poses A and B"), "Y"},
        {Command::ComparePoses, QT_TR_NOOP("Compare poses and methods …"), "Shift+K"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::registrationCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Register, QT_TR_NOOP("Register"), "R"},
        {Command::Stop, QT_TR_NOOP("Stop and keep the best pose"), "Shift+R"},
        {Command::FollowFrames, QT_TR_NOOP("Follow the vessels through the run"), "Shift+F"},
        {Command::NextSolution, QT_TR_NOOP("Show the run's other solutions"), "J", StartsGroup},
        {Command::TakeSolution, QT_TR_NOOP("Take the solution shown"), "Shift+J"},
        {Command::ToggleAuxiliary, QT_TR_NOOP("Selected branches auxiliary on or off"), "A", StartsGroup},
        {Command::AuxiliaryInView, QT_TR_NOOP("Auxiliary: the branches in view"), "V"},
        {Command::AuxiliaryWide, QT_TR_NOOP("Auxiliary: the wider half"), "Shift+V"},
        {Command::Lasso, QT_TR_NOOP("Auxiliary: draw a lasso"), "Ctrl+L", Switch},
        {Command::AuxiliaryAdvice, QT_TR_NOOP("Auxiliary: which branches …"), "Shift+A"},
        {Command::ToggleExcluded, QT_TR_NOOP("Exclude or include selected branches"), "X"},
        {Command::BlindTrial, QT_TR_NOOP("Blind observer trial …"), "", StartsGroup},
        {Command::TrialDone, QT_TR_NOOP("Trial done"), "Ctrl+Return"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::viewCommands()
{
    static constexpr CommandRow rows[]{
        {Command::Fit, QT_TR_NOOP("Fit the image to the window"), "1"},
        {Command::FromSource, QT_TR_NOOP("Seen from the source (mirrored)"), "Q", Switch},
        {Command::Outline, QT_TR_NOOP("Vessels: centreline, outline, tube, radiograph"), "O", StartsGroup},
        {Command::DepthCue, QT_TR_NOOP("Near vessels bright, far ones dim"), "D", Switch},
        {Command::ShowTrace, QT_TR_NOOP("Show traced vessels"), "T", Switch},
        {Command::LessOpacity, QT_TR_NOOP("Overlay fainter"), "[", Repeats},
        {Command::MoreOpacity, QT_TR_NOOP("Overlay stronger"), "]", Repeats},
        {Command::Swipe, QT_TR_NOOP("Swipe, lens, off"), "S"},
        {Command::WorstBranch, QT_TR_NOOP("Zoom to the worst branch, the next"), "W"},
        {Command::DeformedVessels, QT_TR_NOOP("Vessels bent, where that is known, or rigid"), "Shift+Y", Switch},
        {Command::MotionColors, QT_TR_NOOP("Colours: how far bent vessels moved"), "Shift+M", Switch},
        {Command::Flicker, QT_TR_NOOP("Flicker start pose and pose"), "F", Switch | StartsGroup},
        {Command::Replay, QT_TR_NOOP("Replay the last run"), "P", Switch},
        {Command::Swing, QT_TR_NOOP("Swing along what the image cannot tell"), "U", Switch},
        {Command::GantryAngles, QT_TR_NOOP("C-arm angles for the branch …"), "Shift+U"},
        {Command::HideIdentity, QT_TR_NOOP("Hide patient identity"), "Shift+P", Switch | StartsGroup},
        {Command::ResetTreeView, QT_TR_NOOP("3-D view: everything, the vessels alone"), "3", StartsGroup},
        {Command::ScanIn3d, QT_TR_NOOP("Scan in the 3-D view"), "Ctrl+3", Switch},
        {Command::NextScanLook, QT_TR_NOOP("Scan in 3-D: vessels, vessels and bone"), "Ctrl+4"},
        {Command::ScanAtVessels, QT_TR_NOOP("Scan in 3-D: only around the vessels"), "Ctrl+5", Switch},
        {Command::ScanOnDetector, QT_TR_NOOP("Radiograph of the scan on the detector"), "Ctrl+6", Switch},
        {Command::NextCornerView, QT_TR_NOOP("3-D, axial, coronal, sagittal below the branches"), "2"},
        {Command::SlicesLarge, QT_TR_NOOP("Slices instead of the angiogram"), "M", Switch},
        {Command::FullScreen, QT_TR_NOOP("Full screen"), "F11", Switch},
        {Command::ReduceMotion, QT_TR_NOOP("Reduce motion"), "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::brightnessCommands()
{
    static constexpr CommandRow rows[]{
        {Command::AutoWindow, QT_TR_NOOP("Automatic brightness"), "0"},
        {Command::VesselWindow, QT_TR_NOOP("Brightness: the vessels alone"), "Ctrl+0"},
        {Command::SoftWindow, QT_TR_NOOP("Brightness: soft, with bone and catheter"), "Ctrl+9"},
        {Command::FullRange, QT_TR_NOOP("Brightness: every grey value"), "9"},
        {Command::MoreContrast, QT_TR_NOOP("More contrast"), "8", Repeats | StartsGroup},
        {Command::LessContrast, QT_TR_NOOP("Less contrast"), "7", Repeats},
        {Command::Invert, QT_TR_NOOP("Invert grey values"), "I", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::colorCommands()
{
    static constexpr CommandRow rows[]{
        {Command::ColorsBlueAmber, QT_TR_NOOP("Blue to amber"), "", Switch},
        {Command::ColorsBlueRed, QT_TR_NOOP("Blue, white, red"), "", Switch},
        {Command::ColorsBrightness, QT_TR_NOOP("Brightness alone"), "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::placesCommands()
{
    static constexpr CommandRow rows[]{
        {Command::ImageOnly, QT_TR_NOOP("Image alone, without the columns"), "4", Switch},
        {Command::CornerOnly, QT_TR_NOOP("3-D and slices alone"), "5", Switch},
        {Command::ImageWindow, QT_TR_NOOP("Angiogram in a window of its own"), "F7", Switch | StartsGroup},
        {Command::CornerWindow, QT_TR_NOOP("3-D and slices in a window of their own"), "F8", Switch},
        {Command::SlicesWindow, QT_TR_NOOP("All slices in a window of their own"), "F9", Switch},
        {Command::FoldLeft, QT_TR_NOOP("Fold the left column"), "F5", Switch | StartsGroup},
        {Command::FoldRight, QT_TR_NOOP("Fold the right column"), "F6", Switch},
        {Command::LayoutFollowsStep, QT_TR_NOOP("The layout follows the step"), "", Switch | StartsGroup},
        {Command::ResetLayout, QT_TR_NOOP("Layout of this step as it came"), "Shift+F5"},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::themeCommands()
{
    static constexpr CommandRow rows[]{
        {Command::ThemeDark, QT_TR_NOOP("Dark"), "", Switch},
        {Command::ThemeLight, QT_TR_NOOP("Light"), "", Switch},
        {Command::ThemeSystem, QT_TR_NOOP("As the desktop"), "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::languageCommands()
{
    static constexpr CommandRow rows[]{
        {Command::LanguageSystem, QT_TR_NOOP("Language of the desktop"), "", Switch},
        {Command::LanguageEnglish, "English", "", Switch},
        {Command::LanguageGerman, "Deutsch", "", Switch},
        {Command::LanguageChinese, "简体中文", "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::mouseCommands()
{
    static constexpr CommandRow rows[]{
        {Command::MouseRadiology, QT_TR_NOOP("Radiology: left drag windows"), "", Switch},
        {Command::MouseSlicer, QT_TR_NOOP("3D Slicer: left only picks"), "", Switch},
        {Command::MouseScroll, QT_TR_NOOP("Scroll: left drag runs the frames"), "", Switch},
    };
    return rows;
}

std::span<const CommandRow> CommandTable::helpCommands()
{
    static constexpr CommandRow rows[]{
        {Command::PanelHelp, QT_TR_NOOP("Help on what the mouse points at"), "F1"},
        {Command::Tour, QT_TR_NOOP("Short tour")},
        {Command::GoodFit, QT_TR_NOOP("What a good fit looks like"), "Shift+F1"},
        {Command::Keys, QT_TR_NOOP("Keys and mouse"), "?; Ctrl+F1", StartsGroup},
        {Command::Messages, QT_TR_NOOP("Messages"), "Ctrl+Shift+M"},
        {Command::SupportBundle, QT_TR_NOOP("Save support bundle …")},
        {Command::About, QT_TR_NOOP("About AngioPose")},
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