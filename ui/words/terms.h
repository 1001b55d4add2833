#pragma once

#include <QString>
#include <string>
#include <string_view>

namespace angiopose::ui {

/// Returns the display name of a method, or "by hand".
QString methodWords(const std::string& methodId);

/// Translates a term of core's tables: label, help or choice of an option, summary of a method, stage of a registration
/// or reason why it ended. Returns other terms unchanged. Sentences are messages, see message_text.h.
QString termText(std::string_view term);
QString termText(const QString& term);

}   // namespace angiopose::ui
