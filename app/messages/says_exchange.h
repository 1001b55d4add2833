#pragma once

#include "core/support/message.h"

/// Of poses and points that come from other programs, as app/messages/says.h.
namespace angiopose::app::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "app/messages/exchange.def"
#undef MESSAGE

}   // namespace angiopose::app::says
