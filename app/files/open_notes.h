#pragma once

#include "app/jobs/read_inputs.h"
#include "core/case/case.h"

#include <QStringList>

namespace angiopose::app {

/// "a.dcm, b.vtp"
QString namesOf(const QStringList& paths);

/// What to know about the files that were opened, and about how they fit the case they are in now.
QStringList notesOf(const LoadedInputs& inputs, const core::Case& opened);

/// A scan beside vessels of another origin has to have their axes.
QStringList notesOnScan(const LoadedInputs& inputs, const core::Case& opened);

}   // namespace angiopose::app