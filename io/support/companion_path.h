#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace angiopose::io {

/// Parts of the name of a file that is stored next to a case file and named after the case.
struct CompanionName {
    std::optional<std::size_t> otherView;   ///< index of another view of the case, from 0; nullopt for the case itself
    std::string kind;   ///< kind of content, for example "curves"
    std::string extension;   ///< extension without dot, for example "csv"
};

/// Returns the path of such a file: `<case>.<kind>.<extension>`, or `<case>.view-2.<kind>.<extension>` and so on for
/// another view. If a file of that name exists and is not `own`, the file that the case names so far, appends a number
/// to the name.
std::filesystem::path companionPath(const std::filesystem::path& casePath, const CompanionName& name,
                                    const std::filesystem::path& own);

}   // namespace angiopose::io
