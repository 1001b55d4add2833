#pragma once

#include "core/support/message.h"

/// What manifests of a batch can be wrong in, by name, as io/messages/says.h.
namespace angiopose::io::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "io/messages/batch.def"
#undef MESSAGE

}   // namespace angiopose::io::says
