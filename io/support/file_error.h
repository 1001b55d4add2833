#pragma once

#include "core/support/result.h"

#include <string_view>

namespace angiopose::io {

/// Builds a file error in its standard form: file, problem, remedy.
inline core::Error fileError(std::string_view path, const core::Message& problemAndRemedy)
{
    return problemAndRemedy.about(path);
}

/// Adds the file name to an error of reading or writing; a Stop remains a Stop.
inline core::Error fileError(std::string_view path, const core::Error& error)
{
    return error.about(path);
}

}   // namespace angiopose::io
