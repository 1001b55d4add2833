#pragma once

#include <QString>
#include <string>
#include <string_view>

namespace angiopose::ui {

/// The method's name for users, or "by hand".
QString methodWords(const std::string& methodId);

/// A word of core's tables in the language of the window: the label, help or choice of an option, the summary of a
/// method, a stage of a run or why it ended. Others stay as they are. Sentences are messages, see message_text.h.
QString termText(std::string_view term);
QString termText(const QString& term);

}   // namespace angiopose::ui
