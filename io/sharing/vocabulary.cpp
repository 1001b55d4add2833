#include "io/sharing/vocabulary.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr std::size_t significantDigits = 5;

/// Returns the byte length of a character that is a complete word, as in Chinese; 0 for other characters.
std::size_t wordCharacterLength(std::string_view text)
{
    const auto first = static_cast<unsigned char>(text.front());
    return first >= 0xe3 && first <= 0xed && text.size() >= 3 ? 3 : 0;
}

std::size_t wordAt(std::string_view text)
{
    std::size_t size = 0;
    while (size < text.size() && isWordCharacter(text[size]) && wordCharacterLength(text.substr(size)) == 0) {
        ++size;
    }
    return size;
}

bool isNumber(std::string_view word)
{
    return std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
}

constexpr std::ptrdiff_t minUidDots = 4;

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

bool isDateSign(char c)
{
    return c == '-' || c == '.' || c == '/';
}

std::size_t digitsAt(std::string_view text)
{
    return static_cast<std::size_t>(std::ranges::find_if_not(text, isDigit) - text.begin());
}

bool isBetween(std::string_view digits, int least, int most)
{
    const int value = std::stoi(std::string(digits));
    return value >= least && value <= most;
}

/// Returns the byte length of a UID at the start of `text`; 0 if there is none.
std::size_t uidLength(std::string_view text)
{
    const auto end = std::ranges::find_if_not(text, [](char c) { return isDigit(c) || c == '.'; });
    std::string_view run = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    while (run.ends_with('.')) {
        run.remove_suffix(1);
    }
    return std::ranges::count(run, '.') >= minUidDots ? run.size() : 0;
}

/// Returns whether the digits are a date like "19620314", optionally followed by a time.
bool isPlainDate(std::string_view digits)
{
    return (digits.size() == 8 || digits.size() == 12 || digits.size() == 14) &&
           isBetween(digits.substr(0, 4), 1880, 2199) && isBetween(digits.substr(4, 2), 1, 12) &&
           isBetween(digits.substr(6, 2), 1, 31);
}

/// Returns the byte length of a date at the start of `text`; 0 if there is none.
std::size_t dateLength(std::string_view text)
{
    const std::size_t first = digitsAt(text);
    if (isPlainDate(text.substr(0, first))) {
        return first;
    }
    if (first == 0 || first > 4 || first >= text.size() || !isDateSign(text[first])) {
        return 0;
    }
    const std::size_t second = digitsAt(text.substr(first + 1));
    const std::size_t between = first + 1 + second;
    if (second == 0 || second > 2 || between >= text.size() || text[between] != text[first]) {
        return 0;
    }
    const std::size_t third = digitsAt(text.substr(between + 1));
    const bool isYearFirst = first == 4 && (third == 1 || third == 2);
    const bool isYearLast = first <= 2 && (third == 4 || (third == 2 && text[first] != '.'));
    return isYearFirst || isYearLast ? between + 1 + third : 0;
}

}   // namespace

void Vocabulary::add(std::string_view sentence)
{
    const std::string folded = foldCase(sentence);
    for (std::string_view rest = folded; !rest.empty();) {
        const std::size_t size = std::max(wordCharacterLength(rest), wordAt(rest));
        if (size > 0) {
            words_.emplace(rest.substr(0, size));
        }
        rest.remove_prefix(std::max<std::size_t>(size, 1));
    }
}

std::string Vocabulary::keepKnownWords(std::string_view text) const
{
    std::string kept;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t size = std::max(wordCharacterLength(rest), wordAt(rest));
        const std::string_view word = rest.substr(0, std::max<std::size_t>(size, 1));
        rest.remove_prefix(word.size());
        const bool isLetThrough = size == 0 || word.size() == 1 || words_.contains(foldCase(word)) ||
                                  (isNumber(word) && word.size() < significantDigits);
        kept += isLetThrough ? word : std::string_view("[…]");
    }
    return kept;
}

std::string redactUidsAndDates(std::string_view text)
{
    std::string clean;
    for (std::size_t at = 0; at < text.size();) {
        const bool begins = isDigit(text[at]) && (at == 0 || !(isWordCharacter(text[at - 1]) || text[at - 1] == '.'));
        if (!begins) {
            clean += text[at++];
            continue;
        }
        const std::string_view rest = text.substr(at);
        const std::size_t uid = uidLength(rest);
        const std::size_t date = uid > 0 ? 0 : dateLength(rest);
        if (uid + date > 0) {
            clean += uid > 0 ? "[uid]" : "[date]";
            at += uid + date;
            continue;
        }
        const std::size_t digits = digitsAt(rest);
        clean += rest.substr(0, digits);
        at += digits;
    }
    return clean;
}

}   // namespace angiopose::io
