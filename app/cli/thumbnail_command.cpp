#include "app/cli/add_commands.h"

#include "app/cli/console.h"
#include "app/texts/overlay_image.h"
#include "io/image_file.h"
#include "io/opening/read_case_inputs.h"

#include <algorithm>
#include <chrono>
#include <memory>

namespace angiopose::app {
namespace {

struct ThumbnailArguments {
    std::string casePath;
    std::string outputPath;
    int sizePx = 256;
    double limitSeconds = 8.0;
};

using Clock = std::chrono::steady_clock;

/// Returns an observer that stops reading at `end`: slower inputs, such as scans to trace, are not worth a thumbnail.
io::ReadObserver stopAt(Clock::time_point end)
{
    return [end](double) {
        return Clock::now() >= end || isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    };
}

/// Returns the image width at which the longer side has the requested size.
int thumbnailWidth(const core::Case& session, int sizePx)
{
    const auto& angiogram = session.shown().angiogram;
    if (!angiogram || angiogram->frames.empty()) {
        return sizePx;
    }
    const core::ImageF& frame = angiogram->frames.front();
    return std::max(1, sizePx * frame.width / std::max({frame.width, frame.height, 1}));
}

/// Writes a thumbnail without names in the image or in the file, since other programs store thumbnails.
int runThumbnail(const ThumbnailArguments& arguments)
{
    const std::chrono::duration<double> limit(arguments.limitSeconds);
    const io::ReadObserver inTime = stopAt(Clock::now() + std::chrono::duration_cast<Clock::duration>(limit));
    core::Messages nobodyReads;
    const auto session = io::openCase(arguments.casePath, nobodyReads, inTime);
    if (inTime(1.0) == core::ObserverDecision::Stop) {
        return exitInterrupted;
    }
    if (!session) {
        return reportInputError(session.error());
    }
    const auto picture = drawThumbnail(session.value(), thumbnailWidth(session.value(), arguments.sizePx));
    if (!picture) {
        return reportInputError(picture.error());
    }
    const core::Status written = io::writePng(picture.value(), arguments.outputPath);
    return written ? exitSuccess : reportInputError(written.error());
}

}   // namespace

void addThumbnail(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("thumbnail", "Draw a thumbnail of a case without text, for file managers");
    auto arguments = std::make_shared<ThumbnailArguments>();
    command->add_option("CASE", arguments->casePath, "Case file, *.angiopose")->required();
    command->add_option("PICTURE", arguments->outputPath, "Image to write (.png)")->required();
    command->add_option("--size", arguments->sizePx, "Length of the longer side in pixels (default: 256)")
        ->check(CLI::Range(16, 1024));
    command
        ->add_option("--limit", arguments->limitSeconds,
                     "Time limit in seconds for reading the case; if exceeded, no thumbnail is written (default: 8)")
        ->check(CLI::Range(0.0, 600.0));
    command->footer("Example: angiopose-cli thumbnail case.angiopose case.png --size 128");
    command->callback([arguments, &exitCode] { exitCode = runThumbnail(*arguments); });
}

}   // namespace angiopose::app
