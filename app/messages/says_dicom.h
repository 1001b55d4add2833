#pragma once

#include "app/messages/says.h"

/// What the export of DICOM objects can tell; apart from says.h, which much includes.
namespace angiopose::app::says {

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "app/messages/dicom.def"
#undef MESSAGE

}   // namespace angiopose::app::says
