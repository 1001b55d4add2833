#pragma once

#include "io/support/value_cursor.h"

#include <string>

namespace angiopose::io {

/// Walks through a legacy VTK file.
class LegacyVtkCursor : public ValueCursor {
public:
    using ValueCursor::ValueCursor;

    /// `count` values of a VTK type ("float", "vtktypeint64", …); nothing when they are not all there.
    std::optional<std::vector<double>> numbers(std::size_t count, std::string_view type);
    /// `count` strings, one per line in ASCII, length-prefixed in binary.
    std::optional<std::vector<std::string>> strings(std::size_t count);
    void skipParagraph();   ///< up to and including the next blank line

private:
    std::optional<std::size_t> stringLength();
};

}   // namespace angiopose::io
