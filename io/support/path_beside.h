#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace angiopose::io {

/// What a file of a case is called after the case.
struct NameBeside {
    std::optional<std::size_t> otherView;   ///< of one of the case's other views, counted from 0; none: of the case
    std::string kind;   ///< "curves"
    std::string extension;   ///< "csv"
};

/// Where such a file goes: `<case>.<kind>.<extension>`, of another view `<case>.view-2.<kind>.<extension>` and on, with
/// a number where that is somebody else's. `own`: the one that the case names already, which may be written over, if it
/// has such a name: a case file may name any file.
std::filesystem::path pathBeside(const std::filesystem::path& casePath, const NameBeside& name,
                                 const std::filesystem::path& own);

}   // namespace angiopose::io
