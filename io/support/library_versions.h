#pragma once

#include <string>

namespace angiopose::io {

/// Returns the compiler, the build type and the libraries of this layer and the layers below as "key: value" lines.
std::string buildInfo();

}   // namespace angiopose::io
