#pragma once

#include <QString>
#include <string>
#include <string_view>

namespace angiopose::ui {

/// Returns the display name of a method, or "manual" for an empty ID.
QString methodName(const std::string& methodId);

/// Translates a term from the tables of core: the label, help or choice of an option, the summary of a method, the
/// stage of a registration or a stop reason. Returns unknown terms unchanged. For whole sentences, see message_text.h.
QString termText(std::string_view term);
QString termText(const QString& term);

}   // namespace angiopose::ui
