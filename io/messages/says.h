#pragma once

#include "core/support/message.h"

/// Messages of reading and writing, by name; see core/messages/says.h.
namespace angiopose::io::says {

using core::MessageKind;
using core::placesIn;

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "io/messages/case.def"
#include "io/messages/files.def"
#include "io/messages/images.def"
#include "io/messages/movies.def"
#include "io/messages/opening.def"
#include "io/messages/vessels.def"
#include "io/messages/volumes.def"
#undef MESSAGE

}   // namespace angiopose::io::says
