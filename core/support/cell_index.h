#pragma once

#include <cstddef>

namespace angiopose::core {

/// Returns the index of a cell in a row-major grid.
constexpr std::size_t cellIndex(int row, int columns, int column)
{
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
}

}   // namespace angiopose::core
