#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// The one shape of every message about a file: which file, the problem, the remedy.
inline core::Error fileError(std::string_view path, std::string_view problemAndRemedy)
{
    return {std::string(path) + ": " + std::string(problemAndRemedy)};
}

}   // namespace angiopose::io