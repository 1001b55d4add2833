#pragma once

#include <QString>
#include <string>
#include <string_view>

namespace angiopose::ui {

/// Returns the display name of a method, or "manual" for an empty ID.
QString methodName(const std::string& methodId);

/// Translates a term from the tables of core: label, help or choice of an option, summary of a method, stage of a
/// registration or stop reason. Returns unknown terms unchanged. For whole sentences, see message_text.h.
QString termText(std::string_view term);
QString termText(const QString& term);

}   // namespace angiopose::ui
