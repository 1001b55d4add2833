#pragma once

#include "core/support/message.h"

/// Of batches, cases of one's own, foreign readers, results, studies and support, as io/messages/says.h; apart, since
/// few ask.
namespace angiopose::io::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "io/messages/batch.def"
#include "io/messages/own.def"
#include "io/messages/results.def"
#include "io/messages/study.def"
#include "io/messages/support.def"
#undef MESSAGE

}   // namespace angiopose::io::says
