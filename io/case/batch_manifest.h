#pragma once

#include "core/support/result.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// One registration of a batch.
struct BatchEntry {
    int row = 0;   ///< in the manifest, from 1
    std::string casePath;   ///< absolute, or as the manifest's folder resolves it
    std::string name;   ///< its folder in the output; unique
    std::string method;   ///< empty: the case's own
    std::optional<int> frame;   ///< empty: the case's own
};

/// Reads a table with a header row: `case` (a path, relative to the table), and where wanted `name`, `method` and
/// `frame`; other columns are left alone. Without a name an entry is called "0001-CASE" by its row.
/// Fails naming the line: no such column, no rows, an empty path, a name twice or with a slash, a frame that is none.
core::Result<std::vector<BatchEntry>> readManifest(const std::string& path);

}   // namespace angiopose::io