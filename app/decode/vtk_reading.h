#pragma once

#include <vtkAlgorithm.h>
#include <functional>
#include <istream>
#include <string>

namespace angiopose::decode {

std::string contentOf(const std::string& path);

/// Lets a reader of VTK work, its progress told to the program that waits. At the slightest complaint of VTK this
/// process ends with a refusal, for which `place` says where the reader is: some crash when they go on.
void readOrRefuse(vtkAlgorithm& reader, const std::function<std::string()>& place);

}   // namespace angiopose::decode
