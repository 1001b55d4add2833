#pragma once

#include "core/case/case.h"
#include "core/support/message.h"
#include "ui/scenes/render_offscreen.h"

#include <functional>
#include <optional>
#include <string>

namespace angiopose::app {

enum class Identity { Shown, Hidden };

/// "header", "derived", "user", "assumed" or "missing".
core::Message originWord(core::Origin origin);
std::string originText(core::Origin origin);

/// What stands in the corners of a picture, a line each.
struct CornerLines {
    core::Messages topLeft, topRight, bottomLeft, bottomRight;
    std::optional<core::Message> scaleHeading = {};   ///< with the unit; not set: residuals
};

/// Each line as `toText` says it.
ui::CornerTexts textsOf(const CornerLines& lines, const std::function<std::string(const core::Message&)>& toText);

/// As English text, for files.
ui::CornerTexts englishTexts(const CornerLines& lines);

/// Corner texts where readers of other viewers look for them: patient and study on top, geometry with its basis at the
/// bottom right. The bottom left is the caller's: frame, window and zoom belong to the view.
CornerLines cornerLines(const core::Case& session, Identity identity);

}   // namespace angiopose::app