#pragma once

#include "core/support/message.h"

/// Of the evaluation of own cases, as app/messages/says.h.
namespace angiopose::app::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "app/messages/own.def"
#undef MESSAGE

}   // namespace angiopose::app::says
