#pragma once

#include "core/support/message.h"

/// Messages of the command line and of the window's background work, by name; see core/messages/says.h.
namespace angiopose::app::says {

using core::MessageKind;
using core::placesIn;

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "app/messages/commands.def"
#include "app/messages/window.def"
#undef MESSAGE

}   // namespace angiopose::app::says
