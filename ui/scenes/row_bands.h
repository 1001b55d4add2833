#pragma once

#include "core/support/parallel_for.h"

#include <algorithm>
#include <cstddef>

namespace angiopose::ui {

/// Range of canvas rows, `from` to `to` − 1.
struct Rows {
    int from = 0;
    int to = 0;
};

/// Calls `draw` for bands that cover all rows of a canvas, on several threads. Drawing a row must not depend on other
/// rows; the result is then the same for any number of threads.
template <class Draw>
void forEachBand(int height, const Draw& draw)
{
    constexpr int bandRows = 160;   // large, because each band traverses all triangles
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
