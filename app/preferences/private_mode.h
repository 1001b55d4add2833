#pragma once

#include "core/case/case.h"

namespace angiopose::app {

/// Private mode: nothing that could name a case stays behind on this computer or stands in the window's title.
bool isPrivate();

/// The case as it goes into pictures, reports and their metadata: in private mode without the title somebody typed.
core::Case outgoingCase(const core::Case& session);

/// What Qt's own file dialogs remember of the folders they showed goes, for all programs of this user.
void forgetFileDialogs();

/// Forgets what was remembered of cases and people before: lists, pictures, folders, names.
void forgetTraces();

}   // namespace angiopose::app
