#pragma once

#include "core/case/case.h"

#include <QImage>
#include <QStringList>

namespace angiopose::app {

/// Small pictures of recent cases in the user's cache folder: vessels over the image without texts, letters that are
/// part of the image wiped out. They go with the list of recent cases.

/// Width of a picture, device px.
inline constexpr int casePictureWidthPx = 192;

/// Makes and stores the picture of a case file; on a worker. False where there is nothing to show yet.
bool storeCasePicture(const core::Case& session, const QString& casePath);

/// Null where there is none.
QImage casePicture(const QString& casePath);

/// Where the picture of a case lies, if it has one; its name tells nothing about the case.
QString casePicturePath(const QString& casePath);

/// Removes the pictures of all other cases.
void keepCasePictures(const QStringList& casePaths);

/// Paths of cases opened or saved lately, pinned ones first, then newest first.
QStringList recentCases();
void rememberCase(const QString& path);
void forgetCase(const QString& path);   ///< and its picture
void forgetRecentCases();   ///< all but the pinned ones, and their pictures

/// Pinned cases stay in the list and come first.
bool isPinned(const QString& path);
void setPinned(const QString& path, bool pinned);

}   // namespace angiopose::app
