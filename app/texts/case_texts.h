#pragma once

#include "core/case/case.h"
#include "core/support/message.h"
#include "ui/scenes/render_offscreen.h"

#include <functional>
#include <optional>
#include <string>

namespace angiopose::app {

enum class Identity { Shown, Hidden };

/// Returns the name of an origin: "header", "derived", "user", "assumed" or "missing".
core::Message originMessage(core::Origin origin);
std::string originText(core::Origin origin);

/// Text in the corners of an image, one entry per line.
struct CornerLines {
    core::Messages topLeft, topRight, bottomLeft, bottomRight;
    std::optional<core::Message> scaleHeading = {};   ///< heading with the unit; if not set, the scale shows residuals
};

/// Converts each line to text with `toText`.
ui::CornerTexts toCornerTexts(const CornerLines& lines, const std::function<std::string(const core::Message&)>& toText);

/// Converts corner text to English, for files.
ui::CornerTexts englishTexts(const CornerLines& lines);

/// Returns the corner text at the positions customary in DICOM viewers: patient and study at the top, geometry with its
/// origin at the bottom right. The caller fills the bottom left, because frame, window and zoom belong to the view.
CornerLines cornerLines(const core::Case& session, Identity identity);

}   // namespace angiopose::app
