#pragma once

#include "core/support/message.h"

/// What archives and the way to them can tell, by name, as io/messages/says.h.
namespace angiopose::io::says {

using core::MessageKind;
using core::placesIn;

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "io/messages/archive.def"
#undef MESSAGE

}   // namespace angiopose::io::says
