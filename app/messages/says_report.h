#pragma once

#include "core/support/message.h"

/// Messages of reports written without a window; see app/messages/says.h.
namespace angiopose::app::says {

#define MESSAGE(name, id, english) inline constexpr core::MessageKind<core::placesIn(english)> name{{id, english}};
#include "app/messages/report.def"
#undef MESSAGE

}   // namespace angiopose::app::says
