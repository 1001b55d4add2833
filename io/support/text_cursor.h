#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

namespace angiopose::io {

/// Reads a file word by word.
class TextReader {
public:
    explicit TextReader(std::string_view content) : remaining_(content) {}

    bool isAtEnd() const;
    std::size_t left() const { return remaining_.size(); }   ///< number of remaining bytes

    std::string_view line();   ///< text up to the end of the line, trimmed
    std::string_view word();   ///< next word, delimited by blanks; empty at the end
    std::optional<Eigen::Vector3d> point();   ///< point whose coordinates are the next three words

private:
    std::string_view taken(std::size_t count);

    std::string_view remaining_;
};

}   // namespace angiopose::io
