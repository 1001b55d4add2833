#pragma once

#include <set>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Converts ASCII and western European letters (UTF-8) to lower case; the byte length stays the same.
inline std::string foldCase(std::string_view text)
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

/// Returns whether `c` belongs to a word: a digit or a letter of any script.
inline bool isWordCharacter(char c)
{
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z');
}

/// Calls `visit` for every word of `text`.
template <class Visit>
void forEachWord(std::string_view text, const Visit& visit)
{
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = begin;
        while (end < text.size() && isWordCharacter(text[end])) {
            ++end;
        }
        if (end > begin) {
            visit(text.substr(begin, end - begin));
        }
        begin = end + 1;
    }
}

/// Words of the program's own messages; all other words are removed from text that combines messages with user input.
class Vocabulary {
public:
    void add(std::string_view sentence);

    /// Returns `text` with other words, and numbers of five or more digits, replaced by "[…]".
    std::string keepKnownWords(std::string_view text) const;

private:
    std::set<std::string> words_;   ///< lower-case words; Chinese characters are separate words
};

/// Returns `text` with UIDs and dates of any common form replaced by "[uid]" and "[date]".
std::string redactUidsAndDates(std::string_view text);

}   // namespace angiopose::io
