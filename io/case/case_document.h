#pragma once

#include "core/case/case.h"
#include "io/case/fields/view_notes.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// A case file's content before its inputs are loaded.
struct CaseDocument {
    core::Case values;   ///< paths as written; the C-arms hold only what the file gives
    std::vector<ViewNotes> notes;   ///< of `values.views`, in order; nothing noted of those with a file of their own
    std::size_t shownPlace = 0;   ///< where `values.views.front()`, which is shown, belongs among the views
    core::Messages problems;   ///< what makes no sense, each with key and remedy
};

/// Content of a JSON text that follows the schema; unknown keys go to `values`.
CaseDocument parseCaseDocument(std::string_view json);

/// The case as JSON, paths relative to `folder`, unknown keys included.
std::string caseDocumentText(const core::Case& session, const std::filesystem::path& folder);

}   // namespace angiopose::io