#pragma once

#include <string>

namespace angiopose::io {

/// Local time in DICOM format, to the second.
struct LocalTime {
    std::string date;   ///< yyyymmdd
    std::string time;   ///< hhmmss
};
LocalTime localTimeNow();

}   // namespace angiopose::io
