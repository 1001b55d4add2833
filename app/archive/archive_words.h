#pragma once

#include "core/support/message.h"
#include "io/archive/model/node.h"
#include "io/archive/model/query.h"
#include "ui/archive/archive_rows.h"

#include <QString>

#include <optional>
#include <vector>

namespace angiopose::app {

ui::ArchiveEntry entryOf(const io::ArchiveNode& node);
io::ArchiveNode nodeOf(const ui::ArchiveEntry& entry);

/// What was typed as a date and is none.
std::optional<QString> wrongDateOf(const ui::ArchiveSearch& search);
/// A search whose dates are right.
io::ArchiveQuery queryOf(const ui::ArchiveSearch& search);

enum class MatchIdentity { Shown, Hidden };
std::vector<ui::MatchRow> studyMatchRows(const std::vector<io::ArchiveMatch>& studies, MatchIdentity identity);
std::vector<ui::MatchRow> seriesMatchRows(const std::vector<io::ArchiveMatch>& series);

/// "105 MB", in the language of the window.
QString sizeWords(std::uint64_t bytes);

/// What single objects lack: the first of these, and how many more there are.
QString problemWords(const core::Messages& problems);

}   // namespace angiopose::app
