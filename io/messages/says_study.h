#pragma once

#include "core/support/message.h"

/// What reading studies can tell, by name, as io/messages/says.h.
namespace angiopose::io::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "io/messages/study.def"
#undef MESSAGE

}   // namespace angiopose::io::says
