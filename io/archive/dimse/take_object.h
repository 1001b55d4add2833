#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/store/arrivals.h"

#include <string>

namespace angiopose::io {

/// Takes the object of a C-STORE request and answers it. Fails where the association is of no use any more, or nothing
/// more can be taken.
core::Status takeObject(DimseLink& link, const DimseLink::Received& request, const ExpectedObject& expected,
                        Arrivals& arrivals);

/// What stands before the data set of an object in a file (PS3.10 7.1).
struct FileHeader {
    std::string sopClass;
    std::string sopInstance;
    std::string transferSyntax;
    std::string sourceTitle;   ///< of who sent it
};

std::string encodedHeader(const FileHeader& header);

}   // namespace angiopose::io
