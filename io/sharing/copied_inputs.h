#pragma once

#include "core/case/case.h"
#include "io/deidentify/deidentify_dicom.h"
#include "io/support/read_observer.h"

#include <filesystem>
#include <optional>

namespace angiopose::io {

/// Specifies whether inputs are copied into a bundle unchanged or de-identified.
struct CopyOptions {
    std::optional<DeidentificationOptions> deidentification;
    const Pseudonyms& pseudonyms;
};

/// Copies every input of a loaded case into the new folder `folder`, under a name that states the role of the input
/// ("vessels.vtp", "view-1.dcm", "scan/00001.dcm") and makes the case refer to the copies. Views stored in separate
/// cases become views of this case. The hashes are computed when the case is saved. Fails if a required input cannot be
/// copied; omits optional inputs with a warning.
core::Result<core::Messages> copyInputs(core::Case& session, const std::filesystem::path& folder,
                                        const CopyOptions& request, const ReadObserver& observe);

}   // namespace angiopose::io
