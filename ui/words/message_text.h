#pragma once

#include "core/support/message.h"

#include <QString>

#include <optional>

namespace angiopose::ui {

/// Returns a message in the current language, with numbers in that language's decimal format.
QString messageText(const core::Message& message);

/// Returns several messages as consecutive sentences.
QString messagesText(const core::Messages& messages);

/// Returns the text of a message; empty without a message.
QString messageText(const std::optional<core::Message>& message);

}   // namespace angiopose::ui
