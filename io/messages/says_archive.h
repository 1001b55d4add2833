#pragma once

#include "core/support/message.h"

/// Messages about archives and the connection to them, by name; see io/messages/says.h.
namespace angiopose::io::says {

using core::MessageKind;
using core::placesIn;

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "io/messages/archive.def"
#undef MESSAGE

}   // namespace angiopose::io::says
