#pragma once

#include "core/support/message.h"

/// Messages of de-identification; see io/messages/says.h. A separate header, since few files need them.
namespace angiopose::io::says {

using core::MessageKind;
using core::placesIn;

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "io/messages/deidentify.def"
#undef MESSAGE

}   // namespace angiopose::io::says
