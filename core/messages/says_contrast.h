#pragma once

#include "core/support/message.h"

/// Messages of tracing about contrast agent, as in core/messages/says.h; separate because few files need them.
namespace angiopose::core::says {

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "core/messages/contrast.def"
#undef MESSAGE

}   // namespace angiopose::core::says
