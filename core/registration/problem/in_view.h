#pragma once

#include "core/support/result.h"

#include <cstddef>

namespace angiopose::core {

/// Returns the error with the view number added to its message; a cancellation stays unchanged.
Error inView(std::size_t number, const Error& error);

}   // namespace angiopose::core
