#pragma once

#include "core/support/message.h"

/// What tracing tells of contrast medium, as core/messages/says.h; apart, since few ask.
namespace angiopose::core::says {

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "core/messages/contrast.def"
#undef MESSAGE

}   // namespace angiopose::core::says
