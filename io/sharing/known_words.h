#pragma once

#include <set>
#include <string>
#include <string_view>

namespace angiopose::io {

/// In small letters, as long as before: ASCII and the letters of western Europe in UTF-8.
inline std::string foldedText(std::string_view text)
{
    std::string folded(text);
    for (std::size_t i = 0; i < folded.size(); ++i) {
        auto& c = folded[i];
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 'A' && byte <= 'Z') {
            c = static_cast<char>(byte + 32);
        } else if (i > 0 && static_cast<unsigned char>(folded[i - 1]) == 0xc3 && byte >= 0x80 && byte <= 0x9e) {
            c = static_cast<char>(byte + 32);
        }
    }
    return folded;
}

/// Of a word: letters of any script, digits.
inline bool isOfWord(char c)
{
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z');
}

/// Calls `visit` with every word of `text`.
template <class Visit>
void eachWordOf(std::string_view text, const Visit& visit)
{
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = begin;
        while (end < text.size() && isOfWord(text[end])) {
            ++end;
        }
        if (end > begin) {
            visit(text.substr(begin, end - begin));
        }
        begin = end + 1;
    }
}

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

/// `text` with "[uid]" and "[date]" in place of UIDs and of dates in any usual form.
std::string withoutInformativeNumbers(std::string_view text);

}   // namespace angiopose::io
