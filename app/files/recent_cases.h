#pragma once

#include "core/case/case.h"

#include <QImage>
#include <QStringList>

namespace angiopose::app {

/// Thumbnails of recent cases in the user's cache folder: vessels over the image without captions, burned-in text
/// masked. They are removed with the list of recent cases.

/// Width of a thumbnail, device px.
inline constexpr int casePictureWidthPx = 192;

/// Creates and stores the thumbnail of a case file on a worker; returns false if there is nothing to show yet.
bool storeCasePicture(const core::Case& session, const QString& casePath);

/// Reads the thumbnail of a case; null if there is none.
QImage casePicture(const QString& casePath);

/// Path of the thumbnail of a case, if it has one; its name reveals nothing about the case.
QString casePicturePath(const QString& casePath);

/// Removes the thumbnails of all other cases.
void keepCasePictures(const QStringList& casePaths);

/// Paths of recently opened or saved cases: pinned ones first, then newest first.
QStringList recentCases();
void rememberCase(const QString& path);
void forgetCase(const QString& path);   ///< also removes its thumbnail
void forgetRecentCases();   ///< removes all except the pinned ones, with their thumbnails

/// Pinned cases stay in the list and come first.
bool isPinned(const QString& path);
void setPinned(const QString& path, bool pinned);

}   // namespace angiopose::app
