#pragma once

#include "app/start/start_words.h"

namespace angiopose::app {

/// Writes the report that the words ask for, as the window would, without one and without a display; messages go to
/// stderr, in English. The exit code of the program (FORMATS §5).
int writeReport(int argc, char** argv, const ReportWords& words);

}   // namespace angiopose::app
