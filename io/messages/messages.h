#pragma once

#include "core/support/message.h"

/// Messages about reading and writing files; see core/messages/messages.h.
namespace angiopose::io::messages {

#define MESSAGE(name, id, english) \
    inline constexpr core::MessageKind<core::placeholderCount(english)> name{{id, english}};
#include "io/messages/messages.def"
#undef MESSAGE

}   // namespace angiopose::io::messages
