#pragma once

#include "core/support/result.h"

#include <cstddef>

namespace angiopose::core {

/// Adds the view number to an error message; leaves Stop unchanged.
Error inView(std::size_t number, const Error& error);

}   // namespace angiopose::core
