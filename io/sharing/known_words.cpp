#include "io/sharing/known_words.h"

#include "io/sharing/folded_text.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr std::size_t tellingDigits = 5;

/// Bytes of a sign that is a word by itself, as in Chinese.
std::size_t signAt(std::string_view text)
{
    const auto first = static_cast<unsigned char>(text.front());
    return first >= 0xe3 && first <= 0xed && text.size() >= 3 ? 3 : 0;
}

std::size_t wordAt(std::string_view text)
{
    std::size_t size = 0;
    while (size < text.size() && isOfWord(text[size]) && signAt(text.substr(size)) == 0) {
        ++size;
    }
    return size;
}

bool isNumber(std::string_view word)
{
    return std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
}

}   // namespace

void KnownWords::add(std::string_view sentence)
{
    const std::string folded = foldedText(sentence);
    for (std::string_view rest = folded; !rest.empty();) {
        const std::size_t size = std::max(signAt(rest), wordAt(rest));
        if (size > 0) {
            words_.emplace(rest.substr(0, size));
        }
        rest.remove_prefix(std::max<std::size_t>(size, 1));
    }
}

std::string KnownWords::only(std::string_view text) const
{
    std::string kept;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t size = std::max(signAt(rest), wordAt(rest));
        const std::string_view word = rest.substr(0, std::max<std::size_t>(size, 1));
        rest.remove_prefix(word.size());
        const bool isLetThrough = size == 0 || word.size() == 1 || words_.contains(foldedText(word)) ||
                                  (isNumber(word) && word.size() < tellingDigits);
        kept += isLetThrough ? word : std::string_view("[…]");
    }
    return kept;
}

}   // namespace angiopose::io
