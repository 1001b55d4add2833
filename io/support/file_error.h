#pragma once

#include "core/support/result.h"

#include <string_view>

namespace angiopose::io {

/// The one shape of every message about a file: which file, the problem, the remedy.
inline core::Error fileError(std::string_view path, const core::Message& problemAndRemedy)
{
    return problemAndRemedy.about(path);
}

/// What kept a file from being read or written, told of that file; Stop stays Stop.
inline core::Error fileError(std::string_view path, const core::Error& error)
{
    return error.about(path);
}

}   // namespace angiopose::io
