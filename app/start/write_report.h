#pragma once

#include "app/start/start_options.h"

namespace angiopose::app {

/// Writes the report described by `words` as the window would, but without a window or a display; messages go to
/// stderr, in English. Returns the exit code of the program (FORMATS §5).
int writeReport(int argc, char** argv, const ReportCommandOptions& words);

}   // namespace angiopose::app
