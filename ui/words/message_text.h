#pragma once

#include "core/support/message.h"

#include <QString>

#include <optional>

namespace angiopose::ui {

/// Returns a message in the UI language, with numbers in its decimal format.
QString messageText(const core::Message& message);

/// Returns several messages as consecutive sentences.
QString messagesText(const core::Messages& messages);

/// Returns the text of a message; empty if there is none.
QString messageText(const std::optional<core::Message>& message);

}   // namespace angiopose::ui
