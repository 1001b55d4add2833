#pragma once

#include "core/support/result.h"
#include "io/case/case_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// One registration of a batch: of a case, or of the vessels in one file and the angiogram in another.
struct BatchEntry {
    int row = 0;   ///< in the manifest, from 1
    std::string caseCell;   ///< as the manifest has it; empty: the two others
    std::string vesselsCell;
    std::string angiogramCell;
    std::string casePath;   ///< absolute, or as the manifest's folder resolves it
    std::string vesselsPath;
    std::string angiogramPath;
    std::string name;   ///< its folder in the output; unique
    std::string method;   ///< empty: the case's own
    std::optional<int> frame;   ///< empty: the case's own
    CaseSettings settings;   ///< of this row alone
};

/// Reads a table with a header row: `case`, or `vessels` and `angiogram` (paths, relative to the table), and where
/// wanted `seeds` (x y z; x y z), `name`, `method`, `frame` and `set.NAME` (see CaseSettings; an empty cell leaves the
/// case its own); other columns are left alone. Without a name an entry is called "0001-CASE" by its row. Fails naming
/// the line and what is wrong in it.
core::Result<std::vector<BatchEntry>> readManifest(const std::string& path);

}   // namespace angiopose::io
