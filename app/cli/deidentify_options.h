#pragma once

#include "io/deidentify/deidentify_dicom.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <string>

namespace angiopose::app {

/// How identity is taken out, as asked for on the command line.
struct DeidentifyArguments {
    bool isWanted = false;
    std::string dates = "removed";
    bool areLettersBlackedOut = false;
    std::string patientName;
    std::string keyPath;
};

/// `--deidentify` and what goes with it.
std::shared_ptr<DeidentifyArguments> addDeidentifyOptions(CLI::App& command);

/// Nothing where it is not wanted.
std::optional<io::Deidentification> deidentificationOf(const DeidentifyArguments& arguments);

/// With the key in the file that was named, else with a new one. Fails where that file cannot be read or is too short.
core::Result<io::Pseudonyms> pseudonymsOf(const DeidentifyArguments& arguments);

}   // namespace angiopose::app
