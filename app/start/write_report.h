#pragma once

#include "app/start/start_words.h"
#include "core/support/verdict.h"

#include <string_view>

namespace angiopose::app {

/// Ctrl+C, and being told to end, become a wish that running work answers; the second time the program ends at once.
void catchStops();
bool isStopWished();

/// A line on stderr of how far the work is, where a person watches; Stop once that is wished.
core::Verdict watchWork(std::string_view stage, double fraction);

/// Takes that line away.
void endWatch();

/// Writes the report that the words ask for, as the window would, without one and without a display; messages go to
/// stderr, in English. The exit code of the program (FORMATS §5).
int writeReport(int argc, char** argv, const ReportWords& words);

}   // namespace angiopose::app
