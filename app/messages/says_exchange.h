#pragma once

#include "core/support/message.h"

/// Messages about poses and points from other programs; see app/messages/says.h.
namespace angiopose::app::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "app/messages/exchange.def"
#undef MESSAGE

}   // namespace angiopose::app::says
