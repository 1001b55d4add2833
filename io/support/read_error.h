#pragma once

#include "core/support/message.h"

#include <cstddef>
#include <optional>

namespace angiopose::io {

/// Has the system read the first `size` bytes of a mapped file, and says why it cannot: a scratched disc, a drive that
/// went away, a file that another program cut short. To look at such bytes would end the program. Linux before 5.14
/// does not know the question, and nothing is said.
std::optional<core::Message> findReadError(const char* mapping, std::size_t size);

}   // namespace angiopose::io
