#pragma once

#include "core/support/message.h"

/// What taking identity out of files can tell, as io/messages/says.h; apart, since few ask.
namespace angiopose::io::says {

using core::MessageKind;
using core::placesIn;

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "io/messages/deidentify.def"
#undef MESSAGE

}   // namespace angiopose::io::says
