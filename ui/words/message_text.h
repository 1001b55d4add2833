#pragma once

#include "core/support/message.h"

#include <QString>

#include <optional>

namespace angiopose::ui {

/// A message in the language of the window, its numbers with the language's decimal sign.
QString messageText(const core::Message& message);

/// Several, one sentence behind the other.
QString messagesText(const core::Messages& messages);

/// Empty where there is none.
QString messageText(const std::optional<core::Message>& message);

}   // namespace angiopose::ui
