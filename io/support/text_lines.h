#pragma once

#include "io/support/numbers.h"

#include <algorithm>
#include <string_view>

namespace angiopose::io {

/// Takes a text apart into its trimmed lines, leaving out empty ones and comments (`#`), and counts all of them.
///   for (TextLines lines(text); lines.next();) use(lines.line(), lines.number());
class TextLines {
public:
    explicit TextLines(std::string_view text) : rest_(text) {}

    bool next()
    {
        while (!rest_.empty()) {
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            line_ = trimmed(rest_.substr(0, end));
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            ++number_;
            if (!line_.empty() && line_.front() != '#') {
                return true;
            }
        }
        return false;
    }

    std::string_view line() const { return line_; }
    int number() const { return number_; }   ///< in the file, from 1

private:
    std::string_view rest_;
    std::string_view line_;
    int number_ = 0;
};

}   // namespace angiopose::io