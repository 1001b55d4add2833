#pragma once

#include "app/texts/overlay_image.h"
#include "core/support/observer_decision.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::app {

/// Kinds of DICOM objects that can be created from a case (FORMATS §3.6).
enum class DicomKind { Picture, Run, Report, State, Registration, Segmentation, Measurements };

std::string_view idOf(DicomKind kind);   ///< returns "sc", "run", "pdf", "ps", "reg", "seg" or "sr"
std::string dicomKindIds();   ///< returns all IDs, separated by commas
std::optional<DicomKind> parseDicomKind(std::string_view id);

struct DicomExport {
    std::vector<DicomKind> kinds;   ///< if empty, all kinds that the case allows
    OverlayImageOptions imageOptions;
    std::function<core::Result<std::string>()> report = nullptr;   ///< creates the PDF; if not set, there is no report
    std::string author;
};

struct DicomFiles {
    std::vector<std::string> paths;   ///< paths of all files written
    core::Messages notes;   ///< remarks on what was omitted and why, and on what an object cannot represent
};

/// Receives the completed fraction; returning Stop ends the export.
using DicomObserver = std::function<core::ObserverDecision(double fraction)>;

/// Writes the objects of the shown view to a folder, which is created if missing. The objects are new instances in new
/// series of the source image's study. All objects are created before the first is written, so that a failure leaves no
/// incomplete export. Fails if a requested object cannot be created.
core::Result<DicomFiles> writeDicomObjects(const core::Case& session, const core::Centerline2d& target,
                                           const DicomExport& dicomExport, const std::string& folder,
                                           const DicomObserver& observe = {});

}   // namespace angiopose::app
