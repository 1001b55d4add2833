#pragma once

#include "core/support/message.h"

/// Messages of batch processing; see app/messages/says.h.
namespace angiopose::app::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "app/messages/batch.def"
#undef MESSAGE

}   // namespace angiopose::app::says
