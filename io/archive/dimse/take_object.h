#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/store/arrivals.h"

namespace angiopose::io {

/// Receives the object of a C-STORE request and responds. Fails if the association is no longer usable or no more
/// objects can be stored.
core::Status takeObject(DimseLink& link, const DimseLink::Received& request, const ExpectedObject& expected,
                        Arrivals& arrivals);

}   // namespace angiopose::io
