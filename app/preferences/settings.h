#pragma once

#include <QByteArray>
#include <QSettings>
#include <QStringList>

namespace angiopose::app {

/// States whether a preference could identify a case or a person; private mode does not store such values.
enum class Sensitivity { None, Identifying };

/// Stored preference, with its key, type and default in one place.
template <class T>
struct Setting {
    const char* key;
    T fallback;
    Sensitivity sensitivity = Sensitivity::None;

    T read() const
    {
        const QVariant stored = QSettings().value(QLatin1String(key));
        return stored.isValid() ? stored.value<T>() : fallback;
    }
    /// Skips unchanged values, because writing to disk is slow.
    void write(const T& value) const
    {
        QSettings stored;
        if (sensitivity == Sensitivity::Identifying && stored.value(QLatin1String("privacy/private")).toBool()) {
            return;
        }
        if (!stored.contains(QLatin1String(key)) || read() != value) {
            stored.setValue(QLatin1String(key), QVariant::fromValue(value));
        }
    }
    void forget() const { QSettings().remove(QLatin1String(key)); }
};

/// All preferences that persist between sessions. Poses and registration options are stored in the case instead.
namespace settings {
inline const Setting<QString> lastFolder{"files/lastFolder", {}, Sensitivity::Identifying};
inline const Setting<QString> saveFolder{"files/saveFolder", {}, Sensitivity::Identifying};   ///< exports, new cases
inline const Setting<QStringList> recentCases{"files/recentCases", {}, Sensitivity::Identifying};
inline const Setting<QStringList> pinnedCases{
    "files/pinnedCases", {}, Sensitivity::Identifying};   ///< pinned cases, a subset of the recent ones
inline const Setting<bool> recentThumbnails{"files/recentPictures", true};
inline const Setting<QByteArray> windowLayout{"window/layout", {}};
inline const Setting<bool> layoutFollowsStep{"window/layoutFollowsStep", true};
inline const Setting<QByteArray> tracingLayout{"window/steps/tracing", {}};   ///< see ui::ActivityLayout
inline const Setting<QByteArray> registrationLayout{"window/steps/registration", {}};
inline const Setting<QByteArray> reviewLayout{"window/steps/review", {}};
inline const Setting<QString> theme{"window/theme", QStringLiteral("dark")};   ///< dark, light or system
inline const Setting<QString> colors{"window/colors", QStringLiteral("blue-amber")};   ///< see ColorController
inline const Setting<QString> language{"window/language", QStringLiteral("system")};   ///< system, en, de or zh_CN
inline const Setting<QString> mouse{"window/mouse", QStringLiteral("radiology")};   ///< radiology, slicer or scroll
inline const Setting<bool> isTourCompleted{"window/tourSeen", false};
inline const Setting<bool> reduceMotion{"window/reduceMotion", false};
inline const Setting<bool> noticeAccepted{"window/noticeAccepted", false};
inline const Setting<double> overlayOpacity{"view/overlayOpacity", 0.9};
inline const Setting<QStringList> brightness{"view/brightness", {}};   ///< see WindowLevelMemory
inline const Setting<bool> identityHidden{"view/identityHidden", false};
inline const Setting<double> playSpeed{"view/playSpeed", 1.0};   ///< playback speed relative to the acquisition
inline const Setting<bool> playBackAndForth{"view/playBackAndForth", false};
inline const Setting<bool> sideBySide{"view/sideBySide", false};
inline const Setting<double> gantryRao{"angles/rao", -90.0};   ///< gantry limits, degrees
inline const Setting<double> gantryLao{"angles/lao", 90.0};
inline const Setting<double> gantryCaudal{"angles/caudal", -40.0};
inline const Setting<double> gantryCranial{"angles/cranial", 40.0};
inline const Setting<bool> linkedCrosshair{"view/linkedCrosshair", true};   ///< shared by side-by-side views
inline const Setting<double> maskOpacity{"slices/maskOpacity", 0.28};
inline const Setting<double> brushRadiusMm{"slices/brushRadiusMm", 2.0};
inline const Setting<bool> isBrush3d{"slices/brushBall", false};
inline const Setting<bool> brushAboveThreshold{"slices/brushAboveThreshold", false};
inline const Setting<int> cutDepth{"slices/cutDepth", 0};   ///< see ui::CutDepth
inline const Setting<double> cutRangeMm{"slices/cutRangeMm", 10.0};
inline const Setting<int> cornerView{"view/corner", 0};   ///< 0 for 3-D, 1 to 3 for axial, coronal and sagittal
inline const Setting<bool> scanIn3d{"view/scanIn3d", false};
inline const Setting<int> scanPreset{"view/scanLook", 0};   ///< see core::ScanPreset
inline const Setting<bool> scanAtVessels{"view/scanAtVessels", false};
inline const Setting<double> scanStrength{"view/scanStrength", 0.5};
inline const Setting<bool> scanOnDetector{"view/scanOnDetector", false};
inline const Setting<QString> observer{
    "user/observer", {}, Sensitivity::Identifying};   ///< name used in the last blind trial
inline const Setting<QString> trialLog{"user/trialLog", {}, Sensitivity::Identifying};
inline const Setting<double> trialRangeMm{"user/trialRangeMm", 15.0};
inline const Setting<double> trialRangeDeg{"user/trialRangeDeg", 8.0};
inline const Setting<int> exportWidthPx{"export/widthPx", 1024};
inline const Setting<int> exportDotsPerInch{"export/dotsPerInch", 300};
inline const Setting<int> exportFormat{"export/format", 0};   ///< see ui::ImageFileFormat
inline const Setting<QString> reportTemplate{
    "export/reportTemplate", {}, Sensitivity::Identifying};   ///< path of the template; empty: the built-in one is used
inline const Setting<bool> privateMode{"privacy/private", false};   ///< see app/preferences/private_mode.h
inline const Setting<QString> auditFile{"privacy/auditFile", {}};   ///< empty if there is no audit log
inline const Setting<QString> lastReportedCrash{"support/seenFault", {}};   ///< last crash dump shown to the user
inline const Setting<bool> movieIsGif{"export/movieIsGif", false};   ///< if false, movies are MP4
inline const Setting<int> movieWidthPx{"export/movieWidthPx", 1024};
inline const Setting<bool> exportResiduals{"export/residuals", true};
inline const Setting<bool> exportEnglish{"export/english",
                                         false};   ///< if true, exports are in English whatever the UI language
}   // namespace settings

}   // namespace angiopose::app
