#pragma once

#include "core/case/case.h"
#include "io/opening/read_inputs.h"

#include <QStringList>

namespace angiopose::app {

/// "a.dcm, b.vtp"
QString namesOf(const QStringList& paths);

/// What to know about the files that were opened, and about how they fit the case they are in now.
QStringList notesOf(const io::LoadedInputs& inputs, const core::Case& opened);

/// A scan beside vessels of another origin has to have their axes.
QStringList notesOnScan(const io::LoadedInputs& inputs, const core::Case& opened);

}   // namespace angiopose::app