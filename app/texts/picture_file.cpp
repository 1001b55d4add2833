#include "app/texts/picture_file.h"

#include "app/messages/messages.h"
#include "io/image_file.h"
#include "io/results/result_file.h"
#include "io/support/atomic_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace angiopose::app {
namespace {

std::string endOf(const std::string& path)
{
    std::string end = std::filesystem::path(path).extension().string();
    std::ranges::transform(end, end.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return end;
}

/// Returns the case without vessels, results and measurements, for exporting the image alone.
core::Case frameAlone(core::Case session)
{
    session.shown().result.reset();
    session.shown().measurements.clear();
    session.vessels.marks.clear();
    return session;
}

OverlayPictureOptions withoutVessels(OverlayPictureOptions options)
{
    options.vessels = ui::OverlayMode::Hidden;
    options.coloring = OverlayColoring::Branches;
    options.cutout = {};
    options.isStartBeside = false;
    options.drr = nullptr;
    return options;
}

}   // namespace

core::Result<ui::VectorPicture> pictureVectors(const core::Case& session, const core::Centerline2d& target,
                                               const OverlayPictureOptions& options, const PictureFile& file)
{
    if (file.content == PictureContent::Frame16) {
        return core::Error(messages::grayPictureKind());
    }
    const bool isFrame = file.content == PictureContent::Frame;
    return isFrame ? drawOverlayVectors(frameAlone(session), {}, withoutVessels(options))
                   : drawOverlayVectors(session, target, options);
}

SvgFacts factsOf(const core::Case& session, const PictureFile& file)
{
    return {session.title, provenanceTexts(session), file.dotsPerInch};
}

core::Status writePictureFile(const core::Case& session, const core::Centerline2d& target,
                              const OverlayPictureOptions& options, const PictureFile& file, const std::string& path)
{
    if (endOf(path) == ".svg") {
        const auto vectors = pictureVectors(session, target, options, file);
        return vectors ? io::writeAtomically(path, svgOf(vectors.value(), factsOf(session, file)))
                       : core::Status(vectors.error());
    }
    if (endOf(path) != ".png") {
        return core::Error(messages::pictureKindUnknown()).about(path);
    }
    std::map<std::string, std::string> texts = provenanceTexts(session);
    if (file.content == PictureContent::Frame16) {
        const auto& run = session.shown().angiogram;
        return run && session.shown().frame < run->frameCount()
                   ? io::writeGrayPng(*run, session.shown().frame, path, texts, file.dotsPerInch)
                   : core::Status(core::Error(messages::overlayIncomplete()));
    }
    const bool isFrame = file.content == PictureContent::Frame;
    if (!isFrame && session.shown().result) {
        texts["Result"] = io::keptResultJson(
            session, options.identity == Identity::Shown ? io::ResultNames::Kept : io::ResultNames::LeftOut);
    }
    const auto picture =
        isFrame ? drawOverlay(frameAlone(session), {}, withoutVessels(options)) : drawOverlay(session, target, options);
    return picture ? io::writePng(picture.value(), path, texts, file.dotsPerInch) : core::Status(picture.error());
}

}   // namespace angiopose::app
