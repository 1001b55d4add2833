#pragma once

#include "core/support/result.h"

#include <string_view>

namespace angiopose::io {

/// Creates a file error in the standard form: file, problem, remedy.
inline core::Error fileError(std::string_view path, const core::Message& problemAndRemedy)
{
    return problemAndRemedy.about(path);
}

/// Adds the file name to an error from reading or writing; a cancellation remains a cancellation.
inline core::Error fileError(std::string_view path, const core::Error& error)
{
    return error.about(path);
}

}   // namespace angiopose::io
