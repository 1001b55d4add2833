#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace angiopose::io {

/// Parts of the name of a file that is stored next to a case file and named after it.
struct NameBeside {
    std::optional<std::size_t> otherView;   ///< index of another view of the case, from 0; not set for the case itself
    std::string kind;   ///< kind of content, for example "curves"
    std::string extension;   ///< extension without dot, for example "csv"
};

/// Returns the path of such a file: `<case>.<kind>.<extension>`, for another view `<case>.view-2.<kind>.<extension>`
/// and so on, with a number appended if that file belongs to somebody else. `own`: the path that the case already
/// names; it is overwritten only if it has such a name, since a case file may name any file.
std::filesystem::path pathBeside(const std::filesystem::path& casePath, const NameBeside& name,
                                 const std::filesystem::path& own);

}   // namespace angiopose::io
