#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/store/store_writer.h"

namespace angiopose::io {

/// Receives the object of a C-STORE request and responds. Fails if the association is no longer usable or no more
/// objects can be stored.
core::Status receiveObject(DimseLink& link, const DimseLink::ReceivedCommand& request, const ExpectedObject& expected,
                           StoreWriter& storeWriter);

}   // namespace angiopose::io
