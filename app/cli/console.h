#pragma once

#include "core/support/result.h"
#include "core/workflow/observer.h"

#include <string>
#include <string_view>

namespace angiopose::app {

/// Exit codes (FORMATS §5).
enum ExitCode : int {
    exitSuccess = 0,
    exitUsageError = 2,
    exitInputError = 3,
    exitUnreliable = 4,
    exitInterrupted = 130,
};

enum class OutputFormat { Text, Json };

/// Prints a line for readers to stdout, made safe by `printableText`.
void printText(std::string_view line);

/// Prints one message to stderr as "angiopose-cli: message", made safe by `printableText`.
void printMessage(std::string_view message);
void printWarnings(const core::Messages& warnings);

/// Reports why there is no result (invalid input or cancellation by the user) and returns the matching exit code. With
/// JSON output, also prints `{"error": {"id": …}}` to stdout.
int reportInputError(const core::Error& error, OutputFormat format = OutputFormat::Text);

/// Flushes stdout; call it last. Returns `exitCode`, or reports on stderr and returns a failure code if the disk or
/// pipe behind stdout did not accept all output.
int finishOutput(int exitCode);

/// Progress line on stderr, redrawn in place; shows nothing if stderr is not a terminal.
class ProgressLine {
public:
    explicit ProgressLine(std::string label);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(double fraction, std::string_view detail);

    /// Returns an observer that shows the progress of work on a case and that returns Stop after Ctrl+C. The observer
    /// must not outlive this object.
    core::WorkObserver observer();

private:
    std::string label_;
    int lastPercent_ = -1;
    bool isTerminal_;
};

/// Makes Ctrl+C cancel the current work; a second Ctrl+C ends the program immediately.
void installInterruptHandler();
bool isInterrupted();

}   // namespace angiopose::app
