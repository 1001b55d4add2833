#pragma once

#include <QString>

namespace angiopose::app {

/// Suggested folder for a file that belongs to the case: the folder last written to, the folder of the case, the folder
/// last opened, or the user's documents; the first of these that is writable and not part of the program's
/// installation.
QString saveFolder(const QString& casePath);

/// Path of `name` in the suggested folder.
QString suggestedPath(const QString& casePath, const QString& name);

void rememberSaveFolder(const QString& writtenPath);

/// Path of the audit log, set by the environment or in the menu; empty: none.
QString auditPath();

}   // namespace angiopose::app
