#pragma once

#include "core/support/message.h"

/// Messages about poses that are still the initial pose; see app/messages/says.h.
namespace angiopose::app::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "app/messages/starting.def"
#undef MESSAGE

}   // namespace angiopose::app::says
