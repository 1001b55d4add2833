#pragma once

#include "core/support/result.h"
#include "core/workflow/register_case.h"

#include <string>
#include <vector>

namespace angiopose::app {

/// Writes result.json, pose.tfm and overlay.png of each registered view (the shown one into `folder`, the others into
/// view-2, view-3, … below it) and, of several views, joint.json about all; of bent vessels bent.vtp and motion.csv.
/// Makes the folders.
enum class Pictures { Drawn, LeftOut };
core::Status writeOutputs(const core::RegisteredCase& registered, const std::string& folder,
                          Pictures pictures = Pictures::Drawn);

/// Those that are there, as paths in the folder; and takes them away.
std::vector<std::string> outputFilesIn(const std::string& folder);
void removeOutputsIn(const std::string& folder);

/// The same in a few lines for people.
void printRegistered(const core::RegisteredCase& registered, const std::string& folder);

}   // namespace angiopose::app
