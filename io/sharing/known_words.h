#pragma once

#include <set>
#include <string>
#include <string_view>

namespace angiopose::io {

/// The words a program has itself. Of a text that it put together from its own sentences and from what it was given,
/// only these are let through.
class KnownWords {
public:
    void add(std::string_view sentence);

    /// `text` with "[…]" in place of other words, and of numbers of five digits and more.
    std::string only(std::string_view text) const;

private:
    std::set<std::string> words_;   ///< in small letters; signs of Chinese one by one
};

}   // namespace angiopose::io
