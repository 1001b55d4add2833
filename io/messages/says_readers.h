#pragma once

#include "core/support/message.h"

/// Of what libraries cannot read, by name, as io/messages/says.h.
namespace angiopose::io::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "io/messages/readers.def"
#undef MESSAGE

}   // namespace angiopose::io::says
