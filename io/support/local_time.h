#pragma once

#include <string>

namespace angiopose::io {

/// Local time in DICOM format, to the second.
struct LocalTime {
    std::string date;   ///< date, yyyymmdd
    std::string time;   ///< time of day, hhmmss
};
LocalTime localTimeNow();

}   // namespace angiopose::io
