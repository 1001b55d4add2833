#include "app/texts/image_file.h"

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

/// Returns the case without vessels, results and measurements, to export only the image.
core::Case frameAlone(core::Case session)
{
    session.shown().result.reset();
    session.shown().measurements.clear();
    session.vessels.marks.clear();
    return session;
}

OverlayImageOptions withoutVessels(OverlayImageOptions options)
{
    options.vessels = ui::OverlayMode::Hidden;
    options.coloring = OverlayColoring::Branches;
    options.cutout = {};
    options.isInitialPoseShown = false;
    options.drr = nullptr;
    return options;
}

}   // namespace

core::Result<ui::VectorImage> imageVectors(const core::Case& session, const core::Centerline2d& target,
                                           const OverlayImageOptions& options, const ImageFileOptions& file)
{
    if (file.content == ImageFileContent::Frame16) {
        return core::Error(messages::grayPictureKind());
    }
    const bool isFrame = file.content == ImageFileContent::Frame;
    return isFrame ? drawOverlayVectors(frameAlone(session), {}, withoutVessels(options))
                   : drawOverlayVectors(session, target, options);
}

SvgMetadata svgMetadata(const core::Case& session, const ImageFileOptions& file)
{
    return {session.title, provenanceTexts(session), file.dotsPerInch};
}

core::Status writeImageFile(const core::Case& session, const core::Centerline2d& target,
                            const OverlayImageOptions& options, const ImageFileOptions& file, const std::string& path)
{
    if (endOf(path) == ".svg") {
        const auto vectors = imageVectors(session, target, options, file);
        return vectors ? io::writeAtomically(path, toSvgDocument(vectors.value(), svgMetadata(session, file)))
                       : core::Status(vectors.error());
    }
    if (endOf(path) != ".png") {
        return core::Error(messages::pictureKindUnknown()).about(path);
    }
    std::map<std::string, std::string> texts = provenanceTexts(session);
    if (file.content == ImageFileContent::Frame16) {
        const auto& run = session.shown().angiogram;
        return run && session.shown().frame < run->frameCount()
                   ? io::writeGrayPng(*run, session.shown().frame, path, texts, file.dotsPerInch)
                   : core::Status(core::Error(messages::overlayIncomplete()));
    }
    const bool isFrame = file.content == ImageFileContent::Frame;
    if (!isFrame && session.shown().result) {
        texts["Result"] = io::storedResultJson(
            session, options.identity == Identity::Shown ? io::ResultTexts::Kept : io::ResultTexts::LeftOut);
    }
    const auto picture =
        isFrame ? drawOverlay(frameAlone(session), {}, withoutVessels(options)) : drawOverlay(session, target, options);
    return picture ? io::writePng(picture.value(), path, texts, file.dotsPerInch) : core::Status(picture.error());
}

}   // namespace angiopose::app
