#pragma once

#include <QStringList>

namespace angiopose::app {

/// Paths of cases opened or saved lately, newest first.
QStringList recentCases();
void rememberCase(const QString& path);
void forgetRecentCases();   ///< and their pictures

}   // namespace angiopose::app