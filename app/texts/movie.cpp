#include "app/texts/movie.h"

#include "app/messages/messages.h"
#include "app/texts/movie_steps.h"
#include "io/movie/movie_writer.h"

namespace angiopose::app {
namespace {

constexpr core::DisplayRange darkGround{0.0, 1.0};

/// Returns options that are constant over the movie, because display ranges that differ between frames would flicker,
/// and residuals and traced curves are valid for a single frame only.
OverlayImageOptions constantOptions(const core::Case& session, OverlayImageOptions options, const MoviePlan& plan)
{
    options.isInitialPoseShown = false;
    options.drr = plan.content == MovieContent::Turn ? nullptr : options.drr;
    const core::Angiogram& run = *session.shown().angiogram;
    if (plan.content == MovieContent::Turn) {
        options.range = darkGround;
        options.cutout = {};
        options.depthCue = ui::DepthCue::NearBright;
        options.vessels = options.vessels == ui::OverlayMode::Hidden ? ui::OverlayMode::Centerline : options.vessels;
    } else if (!options.range) {
        options.range = core::displayRange(run.frames[static_cast<std::size_t>(session.shown().frame)]);
    }
    if (plan.content != MovieContent::Convergence) {
        options.coloring = OverlayColoring::Branches;   // other frames have different traces or none
    } else if (options.coloring == OverlayColoring::Motion) {
        options.coloring = OverlayColoring::Residuals;   // keeps the color scale the same for all frames
    }
    return options;
}

core::Result<core::ColorImage> pictureOf(const MovieStep& step, const core::Centerline2d& target,
                                         OverlayImageOptions options)
{
    options.words = step.words;
    return drawOverlay(step.session, target, options);
}

core::Status stopped(const std::string& path)
{
    return core::Error(core::Cancellation{messages::movieStopped().about(path)});
}

/// Renders and writes one frame at a time, so that only one is in memory.
core::Status writePictures(io::MovieWriter& movie, const MovieSteps& steps, const core::Centerline2d& target,
                           const OverlayImageOptions& options, core::ColorImage first, const std::string& path,
                           const MovieObserver& observe)
{
    const std::size_t count = steps.count();
    for (std::size_t i = 0; i < count; ++i) {
        if (observe(static_cast<double>(i) / static_cast<double>(count)) == core::ObserverDecision::Stop) {
            return stopped(path);
        }
        const MovieStep step = steps.at(i);
        const auto picture =
            i == 0 ? core::Result<core::ColorImage>(std::move(first)) : pictureOf(step, target, options);
        if (!picture) {
            return picture.error();
        }
        if (auto added = movie.add(picture.value(), step.durationMs); !added) {
            return added;
        }
    }
    return observe(1.0) == core::ObserverDecision::Stop ? stopped(path) : movie.finish();
}

}   // namespace

core::Status writeMovie(const core::Case& session, const core::Centerline2d& target, const OverlayImageOptions& options,
                        const MoviePlan& plan, const std::string& path, const MovieObserver& observe)
{
    if (const auto problem = findProblem(session, plan)) {
        return core::Error(*problem);
    }
    const OverlayImageOptions imageOptions = constantOptions(session, options, plan);
    const MovieSteps steps(session, plan, imageOptions.shape);
    auto first = pictureOf(steps.at(0), target, imageOptions);
    if (!first) {
        return first.error();
    }
    const io::MovieSize size{first.value().width, first.value().height};
    auto movie = io::MovieWriter::create(path, size, {session.title, provenanceTexts(session)});
    return movie ? writePictures(*movie.value(), steps, target, imageOptions, std::move(first).value(), path, observe)
                 : core::Status(movie.error());
}

}   // namespace angiopose::app
