#pragma once

#include "core/support/result.h"
#include "io/case/case_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// One registration of a batch: a case, or a vessel file and an angiogram file.
struct BatchEntry {
    int row = 0;   ///< row of the manifest, from 1
    std::string caseCell;   ///< as written in the manifest; empty: the entry names vessels and angiogram
    std::string vesselsCell;
    std::string angiogramCell;
    std::string casePath;   ///< absolute or relative to the manifest's folder, resolved
    std::string vesselsPath;
    std::string angiogramPath;
    std::string name;   ///< folder name in the output, unique
    std::string method;   ///< empty: the case's method
    std::optional<int> frame;   ///< empty: the case's frame
    CaseSettings settings;   ///< for this row only
};

/// Reads a table with a header row: `case`, or `vessels` and `angiogram` (paths, relative to the table), and optionally
/// `seeds` (x y z; x y z), `name`, `method`, `frame` and `set.NAME` (see CaseSettings; an empty cell keeps the case's
/// value); ignores other columns. An entry without a name is called "0001-CASE" by its row. Errors name the line and
/// the invalid value.
core::Result<std::vector<BatchEntry>> readManifest(const std::string& path);

}   // namespace angiopose::io
