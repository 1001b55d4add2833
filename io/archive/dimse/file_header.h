#pragma once

#include <string>

namespace angiopose::io {

/// What stands before the data set of an object in a file (PS3.10 7.1).
struct FileHeader {
    std::string sopClass;
    std::string sopInstance;
    std::string transferSyntax;
    std::string sourceTitle;   ///< of who sent it
};

std::string encodedHeader(const FileHeader& header);

}   // namespace angiopose::io
