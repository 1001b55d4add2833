#pragma once

#include "core/support/result.h"
#include "core/workflow/observer.h"

#include <string>
#include <string_view>

namespace angiopose::app {

/// FORMATS §5.
enum ExitCode : int {
    exitDone = 0,
    exitUsage = 2,
    exitInput = 3,
    exitNotTrustworthy = 4,
    exitStopped = 130,
};

enum class OutputFormat { Text, Json };

/// A line for people to stdout, as `printableText`.
void printText(std::string_view line);

/// One message to stderr, as `printableText`: "angiopose-cli: message".
void printMessage(std::string_view message);
void printWarnings(const core::Messages& warnings);

/// Reports why there is no result and gives its exit code: that of a wrong input, or of a stop by the user. As JSON it
/// is on stdout too: `{"error": {"id": …}}`.
int failInput(const core::Error& error, OutputFormat format = OutputFormat::Text);

/// To be called last: what was printed has to arrive. The exit code, or that of a failure, which is told on stderr,
/// where the drive or pipe behind stdout took less.
int finishOutput(int exitCode);

/// A progress line on stderr, redrawn in place; silent where stderr is not a terminal.
class ProgressLine {
public:
    explicit ProgressLine(std::string label);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(double fraction, std::string_view detail);

    /// Shows what work on a case reports; answers Ctrl+C with Stop. Not after the line.
    core::WorkObserver observer();

private:
    std::string label_;
    int lastPercent_ = -1;
    bool isTerminal_;
};

/// Ctrl+C becomes a wish to stop that running work answers; a second Ctrl+C ends the program at once.
void catchInterrupts();
bool isInterrupted();

}   // namespace angiopose::app