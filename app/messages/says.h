#pragma once

#include "core/support/message.h"

/// All that the command line and the window's work can tell, by name, as core/messages/says.h.
namespace angiopose::app::says {

using core::MessageKind;
using core::placesIn;

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "app/messages/commands.def"
#include "app/messages/window.def"
#undef MESSAGE

}   // namespace angiopose::app::says
