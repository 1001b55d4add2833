#pragma once

#include "app/messages/says.h"

/// Messages of the DICOM export; separate from says.h, which many files include.
namespace angiopose::app::says {

#define MESSAGE(name, id, english) inline constexpr MessageKind<placesIn(english)> name{{id, english}};
#include "app/messages/dicom.def"
#undef MESSAGE

}   // namespace angiopose::app::says
