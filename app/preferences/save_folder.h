#pragma once

#include <QString>

namespace angiopose::app {

/// Returns the suggested folder for a file that belongs to the case: the folder last written to, the folder of the
/// case, the folder last opened, or the user's documents folder, whichever is first writable and not part of the
/// program's installation.
QString saveFolder(const QString& casePath);

/// Returns the path of `name` in the suggested folder.
QString suggestedPath(const QString& casePath, const QString& name);

void rememberSaveFolder(const QString& writtenPath);

/// Returns the path of the audit log, set by the environment or in the menu; empty if there is none.
QString auditPath();

}   // namespace angiopose::app
