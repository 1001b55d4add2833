#pragma once

#include "core/case/case.h"
#include "io/case/fields/view_notes.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// The contents of a case file before its inputs are loaded.
struct CaseDocument {
    core::Case values;   ///< values in the file; paths are as written, C-arms lack the values from image headers
    std::vector<ViewNotes> notes;   ///< notes on each of `values.views`; empty for views stored in separate case files
    std::size_t shownViewIndex = 0;   ///< index of the shown view (`values.views.front()`) in the order of the views
    core::Messages problems;   ///< invalid values, each with key and remedy
};

/// Parses JSON that conforms to the schema; keeps unknown keys in `values`.
CaseDocument parseCaseDocument(std::string_view json);

/// Returns the case as JSON with paths relative to `folder`, including unknown keys.
std::string caseDocumentJson(const core::Case& session, const std::filesystem::path& folder);

}   // namespace angiopose::io
