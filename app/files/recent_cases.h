#pragma once

#include "core/case/case.h"

#include <QImage>
#include <QStringList>

namespace angiopose::app {

/// Thumbnails of recent cases in the user's cache folder. They show the vessels over the image, without captions and
/// with burned-in text masked, and are removed with the list of recent cases.

/// Width of a thumbnail, device pixels.
inline constexpr int caseThumbnailWidthPx = 192;

/// Creates and stores the thumbnail of a case file; call on a worker. Returns false if there is nothing to show yet.
bool storeCaseThumbnail(const core::Case& session, const QString& casePath);

/// Reads the thumbnail of a case; null if there is none.
QImage caseThumbnail(const QString& casePath);

/// Returns the path of the thumbnail of a case, if it has one; the file name reveals nothing about the case.
QString caseThumbnailPath(const QString& casePath);

/// Removes all thumbnails except those of the given cases.
void pruneCaseThumbnails(const QStringList& casePaths);

/// Paths of recently opened or saved cases: pinned cases first, each group with the newest first.
QStringList recentCases();
void rememberCase(const QString& path);
void forgetCase(const QString& path);   ///< also removes the thumbnail of the case
void forgetRecentCases();   ///< removes all cases except pinned ones, with their thumbnails

/// Returns whether a case is pinned: it stays in the list and comes first.
bool isPinned(const QString& path);
void setPinned(const QString& path, bool pinned);

}   // namespace angiopose::app
