#pragma once

#include <string>

namespace angiopose::io {

/// The local time, to the second, in DICOM format.
struct LocalTime {
    std::string date;   ///< yyyymmdd
    std::string time;   ///< hhmmss
};
LocalTime localTimeNow();

}   // namespace angiopose::io
