#pragma once

#include "core/support/message.h"

/// All messages of core, by name: `says::noSuchBranch(7)` is that message about branch 7. The sentences are in the .def
/// files in this folder; a new message needs a line there and its translations.
namespace angiopose::core::says {

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "core/messages/evaluation.def"
#include "core/messages/geometry.def"
#include "core/messages/measuring.def"
#include "core/messages/registration.def"
#include "core/messages/tracing.def"
#include "core/messages/vessels.def"
#undef MESSAGE

}   // namespace angiopose::core::says
