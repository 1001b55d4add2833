#pragma once

#include <string>

namespace angiopose::io {

/// Compiler, kind of build and the libraries of the layers up to this one, as "key: value" in lines.
std::string buildFacts();

}   // namespace angiopose::io
