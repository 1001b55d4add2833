#pragma once

#include "core/support/result.h"
#include "io/case/case_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// One registration of a batch: a case, or a vessel file and an angiogram file.
struct BatchEntry {
    int row = 0;   ///< row number in the manifest, starting at 1
    std::string caseCell;   ///< case as written in the manifest; empty if the entry names vessels and an angiogram
    std::string vesselsCell;
    std::string angiogramCell;
    std::string casePath;   ///< resolved path of the case: absolute, or relative to the manifest's folder
    std::string vesselsPath;
    std::string angiogramPath;
    std::string name;   ///< unique name of the output folder
    std::string method;   ///< if empty, the method of the case
    std::optional<int> frame;   ///< if not set, the frame of the case
    CaseSettings settings;   ///< settings that apply to this row only
};

/// Reads a table with a header row. Required columns: `case`, or `vessels` and `angiogram` (paths, relative to the
/// table). Optional columns: `seeds` (x y z; x y z), `name`, `method`, `frame` and `set.NAME` (see CaseSettings; an
/// empty cell keeps the case's value). Ignores other columns. An entry without a name is named after its row,
/// "0001-CASE". Errors name the line and the invalid value.
core::Result<std::vector<BatchEntry>> readManifest(const std::string& path);

}   // namespace angiopose::io
