#pragma once

#include "core/case/case.h"
#include "io/opening/read_inputs.h"

#include <QStringList>

namespace angiopose::app {

/// Joins the file names, as in "a.dcm, b.vtp".
QString namesOf(const QStringList& paths);

/// Remarks on the opened files and on how they fit the case they are now part of.
QStringList notesOf(const io::LoadedInputs& inputs, const core::Case& opened);

/// Remarks on a scan opened with vessels of another origin, which must share its axes.
QStringList notesOnScan(const io::LoadedInputs& inputs, const core::Case& opened);

}   // namespace angiopose::app