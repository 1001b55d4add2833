#include "tests/benchmark/text_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace benchmarks {
namespace {

/// Characters on screen; UTF-8 continuation bytes take no room.
std::size_t shownWidth(const std::string& text)
{
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths)
{
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string padding(widths[i] - shownWidth(cells[i]), ' ');
        text += i == 0 ? cells[i] + padding : "  " + padding + cells[i];
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
}

std::string printed(const char* format, int precision, double value)
{
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, precision, value);
    return buffer;
}

}   // namespace

std::string TextTable::toText() const
{
    std::vector<std::size_t> widths;
    for (const std::string& cell : head_) {
        widths.push_back(shownWidth(cell));
    }
    std::size_t total = 0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        for (const std::vector<std::string>& row : rows_) {
            widths[i] = std::max(widths[i], i < row.size() ? shownWidth(row[i]) : 0);
        }
        total += widths[i] + (i > 0 ? 2 : 0);
    }
    std::string text = line(head_, widths) + std::string(total, '-') + "\n";
    for (const std::vector<std::string>& row : rows_) {
        text += line(row, widths);
    }
    return text;
}

std::string fixed(double value, int decimals)
{
    return std::isfinite(value) ? printed("%.*f", decimals, value) : "-";
}

std::string significant(double value)
{
    if (!std::isfinite(value)) {
        return "-";
    }
    return value != 0.0 && std::abs(value) < 1e-3 ? printed("%.*e", 1, value) : printed("%.*f", 3, value);
}

}   // namespace benchmarks
