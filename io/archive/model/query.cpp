#include "io/archive/model/query.h"

#include "io/messages/messages.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <tuple>

namespace angiopose::io {
namespace {

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Converts "2024-01-31" to "20240131" and keeps "20240131"; returns an empty string for anything else.
std::string compactDate(std::string text)
{
    if (text.size() == 10 && text[4] == '-' && text[7] == '-') {
        text = text.substr(0, 4) + text.substr(5, 2) + text.substr(8, 2);
    }
    if (text.size() != 8 || !std::ranges::all_of(text, isDigit)) {
        return {};
    }
    const int month = std::stoi(text.substr(4, 2)), day = std::stoi(text.substr(6, 2));
    return month >= 1 && month <= 12 && day >= 1 && day <= 31 ? text : std::string();
}

/// Returns whether one of the values, separated by backslashes, equals `wanted`.
bool hasValue(const std::string& values, const std::string& wanted)
{
    return ("\\" + values + "\\").find("\\" + wanted + "\\") != std::string::npos;
}

}   // namespace

core::Result<std::string> parseQueryDates(const std::string& text)
{
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) {
        const std::string date = compactDate(text);
        return date.empty() && !text.empty() ? core::Result<std::string>(core::Error(messages::archiveBadDate(text)))
                                             : core::Result<std::string>(date);
    }
    const std::string first = text.substr(0, dots), last = text.substr(dots + 2);
    const std::string from = compactDate(first), to = compactDate(last);
    const bool isWrong =
        (from.empty() && !first.empty()) || (to.empty() && !last.empty()) || (from.empty() && to.empty());
    if (isWrong) {
        return core::Error(messages::archiveBadDate(text));
    }
    return from + "-" + to;
}

bool isUid(const std::string& text)
{
    const bool isPlain = std::ranges::all_of(text, [](char c) { return isDigit(c) || c == '.'; });
    return isPlain && !text.empty() && text.size() <= 64 && isDigit(text.front()) && isDigit(text.back()) &&
           text.find("..") == std::string::npos;
}

std::string namePattern(const std::string& patientName)
{
    const bool isPattern = patientName.empty() || patientName.find_first_of("*?") != std::string::npos;
    return isPattern ? patientName : patientName + "*";
}

void sortAndFilterMatches(const ArchiveQuery& query, std::vector<ArchiveMatch>& found)
{
    std::erase_if(found, [&query](const ArchiveMatch& match) {
        return !query.modality.empty() && !match.modalities.empty() && !hasValue(match.modalities, query.modality);
    });
    std::ranges::stable_sort(found, [](const ArchiveMatch& a, const ArchiveMatch& b) {
        return std::tie(b.studyDate, b.studyTime, a.studyUid, a.seriesNumber, a.seriesUid) <
               std::tie(a.studyDate, a.studyTime, b.studyUid, b.seriesNumber, b.seriesUid);
    });
}

std::string sizeText(std::uint64_t bytes)
{
    constexpr std::array units = {"bytes", "kB", "MB", "GB", "TB"};
    auto value = static_cast<double>(bytes);
    std::size_t unit = 0;
    while (value >= 1000.0 && unit + 1 < units.size()) {
        value /= 1000.0;
        ++unit;
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g %s", value, units.at(unit));
    return text.data();
}

std::string statusText(unsigned status)
{
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "0x%04X", status & 0xffffU);
    return text.data();
}

}   // namespace angiopose::io
