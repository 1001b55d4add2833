#pragma once

#include "core/case/case.h"
#include "io/opening/read_inputs.h"

#include <QStringList>

namespace angiopose::app {

/// Joins file names, e.g. "a.dcm, b.vtp".
QString namesOf(const QStringList& paths);

/// Returns remarks on the opened files and on how they fit the case to which they now belong.
QStringList openNotes(const io::LoadedInputs& inputs, const core::Case& opened);

/// Returns remarks on a scan opened with vessels from another file, which must use the same patient coordinates.
QStringList scanNotes(const io::LoadedInputs& inputs, const core::Case& opened);

}   // namespace angiopose::app
