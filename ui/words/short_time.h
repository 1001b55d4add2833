#pragma once

#include <QString>

#include <string>

namespace angiopose::ui {

/// "14:32" today, "21 Nov 14:32" otherwise, in local time; empty for no time.
QString shortTime(const std::string& isoTime);

}   // namespace angiopose::ui
