#pragma once

#include "core/case/case.h"
#include "io/deidentify/deidentify_dicom.h"
#include "io/support/read_observer.h"

#include <filesystem>
#include <optional>

namespace angiopose::io {

/// How inputs go into a pack: as they are, or without identity.
struct CopyRequest {
    std::optional<Deidentification> deidentified;
    const Pseudonyms& pseudonyms;
};

/// Copies every input of a loaded case into `folder`, which is new, under names that say what they are in the case
/// ("vessels.vtp", "view-1.dcm", "scan/00001.dcm"), and has the case name the copies; views that stand in cases of
/// their own become views of this one. Hashes are left to saving. Fails where an input that the case opens with cannot
/// be copied; what it opens without is left out with a warning.
core::Result<core::Messages> copyInputs(core::Case& session, const std::filesystem::path& folder,
                                        const CopyRequest& request, const ReadObserver& observe);

}   // namespace angiopose::io
