#pragma once

#include "core/support/message.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Returns a null-terminated copy of the text that exists until the program ends, for names that must be literals.
/// Thread-safe.
std::string_view persistentText(const std::string& text);

/// Returns `{"id", "severity", "text", "subject", "arguments"}` for other programs. `text` is the English sentence,
/// `subject` the file or key concerned, if any; numbers are `{"value", "unit", "decimals"}`.
std::string messageJson(const core::Message& message);

/// Returns an array of messages in the format of messageJson.
std::string messagesJson(const core::Messages& messages);

/// Parses messages written by messagesJson; throws std::exception if the text is in another format.
core::Messages parseMessages(std::string_view json);

/// Returns only the English sentences of the messages.
std::vector<std::string> sentencesOf(const core::Messages& messages);

}   // namespace angiopose::io
