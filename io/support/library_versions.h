#pragma once

#include <string>

namespace angiopose::io {

/// Returns the compiler, the build type and the libraries of the layers up to this one, as "key: value" lines.
std::string buildFacts();

}   // namespace angiopose::io
