#pragma once

#include "core/support/message.h"

/// Of cameras and poses as other programs write them, as core/messages/says.h; apart, since few ask.
namespace angiopose::core::says {

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "core/messages/exchange.def"
#undef MESSAGE

}   // namespace angiopose::core::says
