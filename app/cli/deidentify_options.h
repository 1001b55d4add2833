#pragma once

#include "io/deidentify/deidentify_dicom.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <string>

namespace angiopose::app {

/// De-identification options of the command line.
struct DeidentifyArguments {
    bool isRequested = false;
    std::string dates = "removed";
    bool maskBurnedInText = false;
    std::string patientName;
    std::string keyPath;
};

/// Adds `--deidentify` and its related options.
std::shared_ptr<DeidentifyArguments> addDeidentifyOptions(CLI::App& command);

/// Returns the requested de-identification; nullopt if none was requested.
std::optional<io::DeidentificationOptions> deidentificationOf(const DeidentifyArguments& arguments);

/// Creates the pseudonyms from the key in the named file, or from a new key. Fails if the file cannot be read or the
/// key is too short.
core::Result<io::Pseudonyms> pseudonymsOf(const DeidentifyArguments& arguments);

}   // namespace angiopose::app
