#pragma once

#include "core/support/message.h"
#include "io/archive/model/node.h"
#include "io/archive/model/query.h"
#include "ui/archive/archive_rows.h"

#include <QString>

#include <optional>
#include <vector>

namespace angiopose::app {

ui::ArchiveEntry toArchiveEntry(const io::ArchiveNode& node);
io::ArchiveNode toArchiveNode(const ui::ArchiveEntry& entry);

/// Returns the first string that was typed as a date but is not a valid one.
std::optional<QString> firstInvalidDate(const ui::ArchiveSearch& search);
/// Builds a query from the search criteria, whose dates must be valid.
io::ArchiveQuery toArchiveQuery(const ui::ArchiveSearch& search);

enum class IdentityVisibility { Shown, Hidden };
std::vector<ui::MatchRow> studyMatchRows(const std::vector<io::ArchiveMatch>& studies, IdentityVisibility identity);
std::vector<ui::MatchRow> seriesMatchRows(const std::vector<io::ArchiveMatch>& series);

/// Formats a size, e.g. "105 MB", in the UI language.
QString byteSizeText(std::uint64_t bytes);

/// Summarizes problems with individual objects: names the first problem and counts the others.
QString problemSummary(const core::Messages& problems);

}   // namespace angiopose::app
