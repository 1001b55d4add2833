#pragma once

#include "core/support/message.h"

/// Named messages of the command line and of the window's background work; see core/messages/messages.h.
namespace angiopose::app::messages {

#define MESSAGE(name, id, english) \
    inline constexpr core::MessageKind<core::placeholderCount(english)> name{{id, english}};
#include "app/messages/messages.def"
#undef MESSAGE

}   // namespace angiopose::app::messages
