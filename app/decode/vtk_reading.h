#pragma once

#include <vtkAlgorithm.h>
#include <functional>
#include <istream>
#include <string>

namespace angiopose::decode {

std::string readWholeFile(const std::string& path);

/// Runs a VTK reader and reports its progress to the waiting process. At the first VTK error or warning, exits this
/// process with a refusal that contains the reader's position from `place`, since some readers crash if they continue.
void readOrThrow(vtkAlgorithm& reader, const std::function<std::string()>& place);

}   // namespace angiopose::decode
