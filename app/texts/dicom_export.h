#pragma once

#include "app/texts/overlay_picture.h"
#include "core/support/verdict.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::app {

/// What leaves a case as a DICOM object (FORMATS §3.6).
enum class DicomKind { Picture, Run, Report, State, Registration, Segmentation, Measurements };

std::string_view idOf(DicomKind kind);   ///< "sc", "run", "pdf", "ps", "reg", "seg", "sr"
std::string dicomKindIds();   ///< all of them, with commas
std::optional<DicomKind> dicomKindFrom(std::string_view id);

struct DicomExport {
    std::vector<DicomKind> kinds;   ///< empty: all that the case allows
    OverlayPictureOptions look;
    std::function<core::Result<std::string>()> report = nullptr;   ///< makes the PDF; not set: there is none
    std::string author;
};

struct DicomFiles {
    std::vector<std::string> paths;   ///< of all files written
    core::Messages notes;   ///< what was left out and why, and what an object cannot hold
};

/// Told the part that is done; its Stop ends it.
using DicomObserver = std::function<core::Verdict(double fraction)>;

/// Writes the shown view's objects into a folder, which is made where it is not there: new instances in series of their
/// own, in the study of the image they come from. All are made before the first is written, so that nothing is half
/// there. Fails where an object that was asked for cannot be made.
core::Result<DicomFiles> writeDicomObjects(const core::Case& session, const core::Centerline2d& target,
                                           const DicomExport& wanted, const std::string& folder,
                                           const DicomObserver& observe = {});

}   // namespace angiopose::app
