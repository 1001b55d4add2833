#pragma once

#include "core/imaging/image2d.h"
#include "tests/support/for_each.h"

#include <Eigen/Core>
#include <array>
#include <string_view>

namespace angiopose::test {

/// "E", "L", "H", each 5 × 7 px.
inline constexpr std::array<std::array<std::string_view, 7>, 3> drawnLetters{{
    {"#####", "#....", "#....", "####.", "#....", "#....", "#####"},
    {"#....", "#....", "#....", "#....", "#....", "#....", "#####"},
    {"#...#", "#...#", "#...#", "#####", "#...#", "#...#", "#...#"},
}};

/// Writes letters magnified by `scale`, with the upper left corner of the first at `at`.
inline void writeLetters(core::ImageF& frame, const Eigen::Vector2i& at, int count, float value, int scale = 2)
{
    for (int k = 0; k < count; ++k) {
        const auto& letter = drawnLetters[static_cast<std::size_t>(k) % drawnLetters.size()];
        test::forEachPixel(5 * scale, 7 * scale, [&](int column, int row) {
            if (letter[static_cast<std::size_t>(row / scale)][static_cast<std::size_t>(column / scale)] == '#') {
                frame.at(at.x() + 7 * scale * k + column, at.y() + row) = value;
            }
        });
    }
}

}   // namespace angiopose::test
