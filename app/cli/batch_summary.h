#pragma once

#include "core/registration/registration.h"
#include "core/support/result.h"
#include "io/case/batch_manifest.h"

#include <optional>
#include <string>

namespace angiopose::app {

/// How one case of a batch ended.
struct BatchOutcome {
    io::BatchEntry entry;
    std::optional<core::RegistrationResult> result;   ///< nothing when the case failed
    std::optional<core::Error> problem;   ///< why it has none

    /// "done", "not trustworthy", "stopped" or "failed".
    std::string status() const;
};

/// The header row of summary.csv.
std::string summaryHeader();

/// Its row for one case; texts are quoted as RFC 4180 says.
std::string summaryRow(const BatchOutcome& outcome);

}   // namespace angiopose::app