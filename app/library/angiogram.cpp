#include "angiopose/angiogram.h"

#include "app/library/conversions.h"
#include "app/library/observer_adapter.h"
#include "core/tracing/angiogram/run/suggest_frame.h"
#include "io/angiogram_file.h"

namespace angiopose::library {

core::ImageF toCore(const Image& image)
{
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.width < 0 || image.height < 0 || image.pixels.size() != count) {
        throw Error("library.image-size", "An image of " + std::to_string(image.width) + " x " +
                                              std::to_string(image.height) + " pixels cannot have " +
                                              std::to_string(image.pixels.size()) + " values.");
    }
    core::ImageF converted;
    converted.width = image.width;
    converted.height = image.height;
    converted.pixels = image.pixels;
    return converted;
}

core::Polarity toCore(Polarity polarity)
{
    return polarity == Polarity::VesselsDark ? core::Polarity::VesselsDark : core::Polarity::VesselsBright;
}

Polarity toPublic(core::Polarity polarity)
{
    return polarity == core::Polarity::VesselsDark ? Polarity::VesselsDark : Polarity::VesselsBright;
}

core::TraceOptions toCore(const TraceOptions& options)
{
    const auto& [minRadius, maxRadius, minBranch, minComponent, sensitivity] = options;
    return {minRadius, maxRadius, minBranch, minComponent, sensitivity};
}

TraceOptions toPublic(const core::TraceOptions& options)
{
    const auto& [minRadius, maxRadius, minBranch, minComponent, sensitivity] = options;
    return {minRadius, maxRadius, minBranch, minComponent, sensitivity};
}

namespace {

AngiogramTrace publicTrace(core::AngiogramTrace trace)
{
    return {toPublic(trace.centerline),
            std::move(trace.suspectCurves),
            toPublic(std::move(trace.vesselness)),
            toPublic(std::move(trace.vesselMask)),
            toPublic(std::move(trace.fieldMask)),
            toPublic(trace.warnings)};
}

core::Angiogram runOf(const std::vector<Image>& frames, Polarity polarity, const CArm& cArm)
{
    core::Angiogram run;
    if (frames.empty()) {
        throw Error("library.no-frames", "A run needs at least one frame.");
    }
    for (const Image& frame : frames) {
        if (frame.isEmpty() || frame.width != frames.front().width || frame.height != frames.front().height) {
            throw Error("library.frame-size",
                        "The frames of a run must contain pixels and must all have the same size.");
        }
        run.frames.push_back(toCore(frame));
    }
    run.polarity = toCore(polarity);
    run.cArm = toCore(cArm);
    run.suggestedFrame = core::suggestFrame(run.frames, run.polarity);
    return run;
}

/// Returns the frame with this number; throws if there is none.
const core::ImageF& frameAt(const core::Angiogram& run, int frame)
{
    if (frame < 0 || frame >= run.frameCount()) {
        throw Error("library.no-frame", "Frame " + std::to_string(frame) + " does not exist: the run has " +
                                            std::to_string(run.frameCount()) + " frames, the first is 0.");
    }
    return run.frames[static_cast<std::size_t>(frame)];
}

}   // namespace
}   // namespace angiopose::library

namespace angiopose {

Angiogram::Angiogram(const std::vector<Image>& frames, Polarity polarity, const CArm& cArm)
    : content_(std::make_shared<const core::Angiogram>(library::runOf(frames, polarity, cArm)))
{
}

Angiogram::Angiogram(std::shared_ptr<const core::Angiogram> content) : content_(std::move(content)) {}

int Angiogram::width() const
{
    return content_->width();
}

int Angiogram::height() const
{
    return content_->height();
}

int Angiogram::frameCount() const
{
    return content_->frameCount();
}

std::span<const float> Angiogram::pixels(int frame) const
{
    return library::frameAt(*content_, frame).pixels;
}

Image Angiogram::frame(int frame) const
{
    return library::toPublic(core::ImageF(library::frameAt(*content_, frame)));
}

Polarity Angiogram::polarity() const
{
    return library::toPublic(content_->polarity);
}

CArm Angiogram::cArm() const
{
    return library::toPublic(content_->cArm);
}

double Angiogram::frameTimeMs() const
{
    return content_->frameTimeMs;
}

int Angiogram::suggestedFrame() const
{
    return content_->suggestedFrame;
}

std::vector<Message> Angiogram::warnings() const
{
    return library::toPublic(content_->warnings);
}

Angiogram readAngiogram(const std::string& path)
{
    return Angiogram(std::make_shared<const core::Angiogram>(library::valueOf(io::readAngiogram(path))));
}

void writeAngiogram(const Angiogram& angiogram, const std::string& path)
{
    library::check(io::writeAngiogram(*angiogram.content(), path));
}

AngiogramTrace traceAngiogram(const Image& frame, Polarity polarity, const TraceOptions& options)
{
    return library::publicTrace(library::valueOf(
        core::traceAngiogram(library::toCore(frame), library::toCore(polarity), library::toCore(options))));
}

AngiogramTrace traceFrame(const Angiogram& run, int frame, const TraceOptions& options)
{
    return library::publicTrace(library::valueOf(core::traceFrame(*run.content(), frame, library::toCore(options))));
}

}   // namespace angiopose
