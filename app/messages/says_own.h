#pragma once

#include "core/support/message.h"

/// Messages of the evaluation on the user's own cases; see app/messages/says.h.
namespace angiopose::app::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "app/messages/own.def"
#undef MESSAGE

}   // namespace angiopose::app::says
