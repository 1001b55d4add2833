#pragma once

#include "core/support/message.h"

/// What the evaluation of own cases can tell, by name, as io/messages/says.h.
namespace angiopose::io::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "io/messages/own.def"
#undef MESSAGE

}   // namespace angiopose::io::says
