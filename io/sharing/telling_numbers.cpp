#include "io/sharing/telling_numbers.h"

#include "io/sharing/folded_text.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr std::ptrdiff_t leastUidDots = 4;

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

/// Bytes of a UID that `text` begins with; 0: none.
std::size_t uidAt(std::string_view text)
{
    const auto end = std::ranges::find_if_not(text, [](char c) { return isDigit(c) || c == '.'; });
    std::string_view run = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    while (run.ends_with('.')) {
        run.remove_suffix(1);
    }
    return std::ranges::count(run, '.') >= leastUidDots ? run.size() : 0;
}

/// "19620314", also with a time behind it.
bool isPlainDate(std::string_view digits)
{
    return (digits.size() == 8 || digits.size() == 12 || digits.size() == 14) &&
           isBetween(digits.substr(0, 4), 1880, 2199) && isBetween(digits.substr(4, 2), 1, 12) &&
           isBetween(digits.substr(6, 2), 1, 31);
}

/// Bytes of a date that `text` begins with; 0: none.
std::size_t dateAt(std::string_view text)
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

std::string withoutTellingNumbers(std::string_view text)
{
    std::string clean;
    for (std::size_t at = 0; at < text.size();) {
        const bool begins = isDigit(text[at]) && (at == 0 || !(isOfWord(text[at - 1]) || text[at - 1] == '.'));
        if (!begins) {
            clean += text[at++];
            continue;
        }
        const std::string_view rest = text.substr(at);
        const std::size_t uid = uidAt(rest);
        const std::size_t date = uid > 0 ? 0 : dateAt(rest);
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
