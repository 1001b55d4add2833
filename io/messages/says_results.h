#pragma once

#include "core/support/message.h"

/// Of results that are opened, by name, as io/messages/says.h.
namespace angiopose::io::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "io/messages/results.def"
#undef MESSAGE

}   // namespace angiopose::io::says
