#pragma once

#include "core/support/message.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// The same text, ended by a zero and there until the program ends: for names that the program itself has as literals.
/// Called from any thread.
std::string_view lasting(const std::string& text);

/// `{"id", "severity", "text", "subject", "arguments"}` for programs: `text` is the English sentence, `subject` the
/// file or key it is about, where there is one; numbers are `{"value", "unit", "decimals"}`.
std::string messageJson(const core::Message& message);

/// An array of them.
std::string messagesJson(const core::Messages& messages);

/// Messages as messagesJson wrote them; throws std::exception where they are not.
core::Messages messagesFrom(std::string_view json);

/// The English sentences alone.
std::vector<std::string> sentencesOf(const core::Messages& messages);

}   // namespace angiopose::io
