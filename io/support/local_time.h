#pragma once

#include <string>

namespace angiopose::io {

/// The time on the clock here, to the second, as DICOM writes it.
struct LocalTime {
    std::string date;   ///< yyyymmdd
    std::string time;   ///< hhmmss
};
LocalTime localTimeNow();

}   // namespace angiopose::io
