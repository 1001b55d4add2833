#pragma once

#include "core/support/message.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// `{"id", "severity", "text", "subject", "arguments"}` for programs: `text` is the English sentence, `subject` the
/// file or key it is about, where there is one; numbers are `{"value", "unit"}`.
std::string messageJson(const core::Message& message);

/// An array of them.
std::string messagesJson(const core::Messages& messages);

/// The English sentences alone.
std::vector<std::string> sentencesOf(const core::Messages& messages);

}   // namespace angiopose::io
