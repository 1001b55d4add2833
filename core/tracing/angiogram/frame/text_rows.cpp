#include "core/tracing/angiogram/frame/text_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiopose::core {
namespace {

constexpr std::size_t minInRow = 3;

/// Returns whether two shapes belong to one line of text: similar height, same baseline, at most two letters apart.
bool areInOneRow(const Glyph& a, const Glyph& b)
{
    const int height = std::max(a.height(), b.height());
    const int gap = std::max(a.left, b.left) - std::min(a.right, b.right);
    return std::min(a.height(), b.height()) >= 0.6 * height && std::abs(a.bottom - b.bottom) <= 0.4 * height &&
           gap > 0 && gap <= 2 * height;
}

/// Removes one row of glyphs from `remaining` and returns the row.
std::vector<Glyph> extractTextRow(std::vector<Glyph>& remaining)
{
    std::vector<Glyph> row{remaining.back()};
    remaining.pop_back();
    for (std::size_t next = 0; next < row.size(); ++next) {
        const auto firstInRow = std::stable_partition(
            remaining.begin(), remaining.end(), [&](const Glyph& glyph) { return !areInOneRow(row[next], glyph); });
        row.insert(row.end(), firstInRow, remaining.end());
        remaining.erase(firstInRow, remaining.end());
    }
    return row;
}

}   // namespace

Glyph boundsOf(const std::vector<std::size_t>& pixels, int imageWidth)
{
    Glyph glyph{imageWidth, -1, 1 << 30, -1};
    for (const std::size_t p : pixels) {
        const int x = static_cast<int>(p % static_cast<std::size_t>(imageWidth));
        const int y = static_cast<int>(p / static_cast<std::size_t>(imageWidth));
        glyph = {std::min(glyph.left, x), std::max(glyph.right, x), std::min(glyph.top, y), std::max(glyph.bottom, y)};
    }
    return glyph;
}

std::vector<std::vector<Glyph>> findTextRows(std::vector<Glyph> glyphs)
{
    std::vector<std::vector<Glyph>> rows;
    while (!glyphs.empty()) {
        std::vector<Glyph> row = extractTextRow(glyphs);
        if (row.size() >= minInRow) {
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

}   // namespace angiopose::core
