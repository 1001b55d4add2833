#pragma once

#include "core/support/parallel_for.h"

#include <algorithm>
#include <cstddef>

namespace angiopose::ui {

/// Rows `from` … `to` − 1 of a canvas.
struct Rows {
    int from = 0;
    int to = 0;
};

/// Calls `draw` for all rows of a canvas, in bands and on several threads. Rows must be drawn independently, which
/// makes the result the same for any number of threads.
template <class Draw>
void forBands(int height, const Draw& draw)
{
    constexpr int bandRows = 160;   // each band traverses all triangles once
    constexpr int maxThreads = 4;
    const int bands = std::max(1, (height + bandRows - 1) / bandRows);
    const auto band = [&](std::size_t index) {
        const int from = static_cast<int>(index) * bandRows;
        draw(Rows{from, std::min(from + bandRows, height)});
    };
    core::parallelFor(static_cast<std::size_t>(bands), std::min({bands, maxThreads, core::threadCount(0)}), band,
                      [](double) { return true; });
}

}   // namespace angiopose::ui