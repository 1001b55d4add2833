#pragma once

#include "core/support/result.h"
#include "core/workflow/register_case.h"

#include <string>
#include <vector>

namespace angiopose::app {

/// Specifies whether the overlay images are written.
enum class OverlayImages { Drawn, LeftOut };

/// Writes result.json, pose.tfm and overlay.png of each registered view: those of the shown view into `folder`, those
/// of the others into its subfolders view-2, view-3, …. Adds joint.json for several views, and bent.vtp and motion.csv
/// for deformed vessels. Creates the folders.
core::Status writeOutputs(const core::RegisteredCase& registered, const std::string& folder,
                          OverlayImages pictures = OverlayImages::Drawn);

/// List and remove the outputs that exist in a folder; the paths are relative to the folder.
std::vector<std::string> listOutputs(const std::string& folder);
void removeOutputs(const std::string& folder);

/// Prints a human-readable summary of the registration.
void printSummary(const core::RegisteredCase& registered, const std::string& folder);

}   // namespace angiopose::app
