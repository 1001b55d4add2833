#pragma once

#include "io/messages/says.h"

/// What DICOM objects that are written can tell; apart from says.h, which much includes.
namespace angiopose::io::says {

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "io/messages/objects.def"
#undef MESSAGE

}   // namespace angiopose::io::says
