#pragma once

#include <QString>

#include <string>

namespace angiopose::ui {

/// The method's name for users, or "by hand".
QString methodWords(const std::string& methodId);

}   // namespace angiopose::ui
