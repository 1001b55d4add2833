#pragma once

#include "core/support/message.h"

/// Messages about batches, the user's own cases, external readers, results, studies and support; see
/// io/messages/says.h. A separate header, since few files need them.
namespace angiopose::io::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "io/messages/batch.def"
#include "io/messages/own.def"
#include "io/messages/results.def"
#include "io/messages/study.def"
#include "io/messages/support.def"
#undef MESSAGE

}   // namespace angiopose::io::says
