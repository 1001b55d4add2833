#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/store/arrivals.h"

namespace angiopose::io {

/// Takes the object of a C-STORE request and answers it. Fails where the association is of no use any more, or nothing
/// more can be taken.
core::Status takeObject(DimseLink& link, const DimseLink::Received& request, const ExpectedObject& expected,
                        Arrivals& arrivals);

}   // namespace angiopose::io
