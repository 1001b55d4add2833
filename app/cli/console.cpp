#include "app/cli/console.h"

#include "app/messages/messages.h"
#include "app/texts/number_text.h"
#include "app/texts/printable_text.h"
#include "io/support/message_json.h"
#include "io/support/system/current_process.h"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

namespace angiopose::app {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the signal handler must not lock");

extern "C" void onInterrupt(int signal)
{
    interrupted = true;
    std::signal(signal, SIG_DFL);
}

}   // namespace

void printText(std::string_view line)
{
    std::printf("%s\n", printableText(line).c_str());
}

void printMessage(std::string_view message)
{
    std::fprintf(stderr, "angiopose-cli: %s\n", printableText(message).c_str());
}

void printWarnings(const core::Messages& warnings)
{
    for (const core::Message& warning : warnings) {
        printMessage("warning: " + warning.text());
    }
}

int reportInputError(const core::Error& error, OutputFormat format)
{
    printMessage(error.message.text());
    if (format == OutputFormat::Json) {
        const auto json = nlohmann::ordered_json::parse("{\"error\":" + io::messageJson(error.message) + "}");
        std::puts(json.dump(2).c_str());
    }
    return error.isCancellation() || isInterrupted() ? exitInterrupted : exitInputError;
}

int finishOutput(int exitCode)
{
    const bool isWritten = std::cout.flush() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (isWritten) {
        return exitCode;
    }
    printMessage(messages::outputNotWritten().text());
    return exitCode == exitSuccess ? exitInputError : exitCode;
}

ProgressLine::ProgressLine(std::string label) : label_(std::move(label)), isTerminal_(io::isTerminal(stderr)) {}

ProgressLine::~ProgressLine()
{
    if (lastPercent_ >= 0) {
        std::fputs("\r\x1b[K", stderr);
    }
}

void ProgressLine::show(double fraction, std::string_view detail)
{
    const int percent = static_cast<int>(100.0 * fraction);
    if (!isTerminal_ || percent == lastPercent_) {
        return;
    }
    lastPercent_ = percent;
    std::fprintf(stderr, "\r\x1b[K%s %3d %%  %s", label_.c_str(), percent, printableText(detail).c_str());
    std::fflush(stderr);
}

core::WorkObserver ProgressLine::observer()
{
    return [this](const core::WorkReport& report) {
        std::string detail(report.stage);
        if (report.iteration) {
            detail += ", median " + fixedText(report.iteration->medianDistancePx, 2) + " px";
        }
        show(report.fraction, detail);
        return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    };
}

void installInterruptHandler()
{
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
}

bool isInterrupted()
{
    return interrupted;
}

}   // namespace angiopose::app
