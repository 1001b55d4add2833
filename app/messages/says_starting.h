#pragma once

#include "core/support/message.h"

/// Of poses that are still where they start, as app/messages/says.h.
namespace angiopose::app::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "app/messages/starting.def"
#undef MESSAGE

}   // namespace angiopose::app::says
