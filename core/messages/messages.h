#pragma once

#include "core/support/message.h"

/// All messages of core by name: `messages::noSuchBranch(7)` is that message for branch 7. The text is in messages.def;
/// a new message needs a line there and its translations.
namespace angiopose::core::messages {

#define MESSAGE(name, id, english) inline constexpr MessageKind<placeholderCount(english)> name{{id, english}};
#include "core/messages/messages.def"
#undef MESSAGE

}   // namespace angiopose::core::messages
