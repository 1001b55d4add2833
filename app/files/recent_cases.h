#pragma once

#include <QStringList>

namespace angiopose::app {

/// Paths of cases opened or saved lately, pinned ones first, then newest first.
QStringList recentCases();
void rememberCase(const QString& path);
void forgetCase(const QString& path);   ///< and its picture
void forgetRecentCases();   ///< all but the pinned ones, and their pictures

/// Pinned cases stay in the list and come first.
bool isPinned(const QString& path);
void setPinned(const QString& path, bool pinned);

}   // namespace angiopose::app