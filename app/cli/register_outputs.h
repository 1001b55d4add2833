#pragma once

#include "core/support/result.h"
#include "core/workflow/register_case.h"

#include <string>
#include <vector>

namespace angiopose::app {

/// Writes result.json, pose.tfm and overlay.png of each registered view (the displayed one into `folder`, the others
/// into view-2, view-3, … below it). Several views add joint.json for all; deformed vessels add bent.vtp and
/// motion.csv. Creates the folders.
enum class Pictures { Drawn, LeftOut };
core::Status writeOutputs(const core::RegisteredCase& registered, const std::string& folder,
                          Pictures pictures = Pictures::Drawn);

/// List and remove the outputs present in a folder, as paths relative to it.
std::vector<std::string> outputFilesIn(const std::string& folder);
void removeOutputsIn(const std::string& folder);

/// Prints a human-readable summary of the registration.
void printRegistered(const core::RegisteredCase& registered, const std::string& folder);

}   // namespace angiopose::app
