#pragma once

#include "core/support/message.h"

/// Messages about saving and storing files, by name; see io/messages/says.h.
namespace angiopose::io::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "io/messages/keeping.def"
#undef MESSAGE

}   // namespace angiopose::io::says
