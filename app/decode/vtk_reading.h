#pragma once

#include <vtkAlgorithm.h>
#include <functional>
#include <istream>
#include <string>

namespace angiopose::decode {

std::string contentOf(const std::string& path);

/// Runs a VTK reader and reports its progress to the waiting program. At the first error or warning from VTK, this
/// process exits with a refusal, for which `place` describes the reader's position: some readers crash when they
/// continue.
void readOrRefuse(vtkAlgorithm& reader, const std::function<std::string()>& place);

}   // namespace angiopose::decode
