#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Walks through the tokens and number blocks of a legacy VTK file. Nothing is allocated for values that the rest of
/// the file cannot hold.
class LegacyVtkCursor {
public:
    explicit LegacyVtkCursor(std::string_view content) : rest_(content) {}

    void setBinary() { isBinary_ = true; }
    bool isBinary() const { return isBinary_; }
    bool isAtEnd();

    std::string_view line();   ///< up to the next line end, without it
    std::string_view token();   ///< next word; empty at the end
    std::string_view peekToken();
    std::optional<std::size_t> count();   ///< next word as a non-negative whole number

    /// `count` values of a VTK type ("float", "vtktypeint64", …); nothing when they are not all there.
    std::optional<std::vector<double>> numbers(std::size_t count, std::string_view type);
    /// The same, without keeping them.
    bool skipNumbers(std::size_t count, std::string_view type);
    /// `count` strings, one per line in ASCII, length-prefixed in binary.
    std::optional<std::vector<std::string>> strings(std::size_t count);
    void skipParagraph();   ///< up to and including the next blank line

private:
    std::optional<std::vector<double>> asciiNumbers(std::size_t count);
    std::optional<std::vector<double>> binaryNumbers(std::size_t count, std::string_view type);
    std::optional<std::size_t> binaryStringLength();

    std::string_view rest_;
    bool isBinary_ = false;
};

}   // namespace angiopose::io