#pragma once

#include "core/support/message.h"

/// Messages about cameras and poses in the formats of other programs, as in core/messages/says.h; separate because few
/// files need them.
namespace angiopose::core::says {

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "core/messages/exchange.def"
#undef MESSAGE

}   // namespace angiopose::core::says
