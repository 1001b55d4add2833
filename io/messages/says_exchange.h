#pragma once

#include "core/support/message.h"

/// Messages about poses, cameras and points exchanged with other programs, by name; see io/messages/says.h.
namespace angiopose::io::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "io/messages/exchange.def"
#undef MESSAGE

}   // namespace angiopose::io::says
