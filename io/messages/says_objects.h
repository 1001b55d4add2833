#pragma once

#include "io/messages/says.h"

/// Messages about writing DICOM objects; separate from says.h, which many files include.
namespace angiopose::io::says {

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "io/messages/objects.def"
#undef MESSAGE

}   // namespace angiopose::io::says
