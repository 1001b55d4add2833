#pragma once

#include "core/case/case.h"

namespace angiopose::app {

/// Returns whether private mode is on: nothing that could identify a case is stored here or shown in the window title.
bool isPrivate();

/// Returns the case for exported images, reports and their metadata: in private mode, without the user's title.
core::Case caseForExport(const core::Case& session);

/// Clears the folder history of Qt's file dialogs for all programs of this user.
void clearFileDialogHistory();

/// Clears all stored data about earlier cases and people: lists, thumbnails, folders and names.
void clearStoredData();

}   // namespace angiopose::app
