#pragma once

#include "core/support/result.h"

#include <cstddef>

namespace angiopose::core {

/// What went wrong in the view of that number; Stop stays Stop.
Error inView(std::size_t number, const Error& error);

}   // namespace angiopose::core
