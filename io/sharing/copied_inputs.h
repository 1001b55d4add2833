#pragma once

#include "core/case/case.h"
#include "io/deidentify/deidentify_dicom.h"
#include "io/support/read_observer.h"

#include <filesystem>
#include <optional>

namespace angiopose::io {

/// Whether inputs are copied into a bundle unchanged or de-identified.
struct CopyRequest {
    std::optional<Deidentification> deidentified;
    const Pseudonyms& pseudonyms;
};

/// Copies every input of a loaded case into the new `folder`, under names that state its role ("vessels.vtp",
/// "view-1.dcm", "scan/00001.dcm"), and points the case to the copies. Views stored in separate cases become views of
/// this one. Saving computes the hashes. Fails if a required input cannot be copied; omits an optional one with a
/// warning.
core::Result<core::Messages> copyInputs(core::Case& session, const std::filesystem::path& folder,
                                        const CopyRequest& request, const ReadObserver& observe);

}   // namespace angiopose::io
