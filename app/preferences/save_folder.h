#pragma once

#include <QString>

namespace angiopose::app {

/// Where a file that goes with the case is suggested: where the last one was written, beside the case, where files were
/// last opened, the user's documents; the first of these that can be written to and is not the program's own.
QString saveFolder(const QString& casePath);

/// The path `name` has in the suggested folder.
QString suggestedPath(const QString& casePath, const QString& name);

void rememberSaveFolder(const QString& writtenPath);

/// The audit file that is wished, by the environment or in the menu; empty: none.
QString auditPath();

}   // namespace angiopose::app
