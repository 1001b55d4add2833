#include "app/texts/dicom_pictures.h"

#include "app/messages/says_dicom.h"
#include "app/texts/movie_steps.h"
#include "core/tracing/angiogram/frame/burned_in_text.h"
#include "io/dicom/objects/secondary_capture.h"

#include <algorithm>

namespace angiopose::app {
namespace {

/// Names are written with `^` between their parts, titles with blanks.
std::vector<std::string> wordsOf(const std::string& text)
{
    std::vector<std::string> words;
    std::string word;
    for (const char letter : text + " ") {
        if (letter == '^' || letter == ' ' || letter == '=' || letter == ',') {
            if (word.size() > 2) {
                words.push_back(word);
            }
            word.clear();
        } else {
            word += letter;
        }
    }
    return words;
}

bool namesPatient(const std::string& title, const io::SourceImage& source)
{
    const std::vector<std::string> words =
        wordsOf(source.patientText(0x00100010) + " " + source.patientText(0x00100020));
    return std::ranges::any_of(words, [&](const std::string& word) { return title.find(word) != std::string::npos; });
}

/// Letters in the image are not read: where there are any, they may be a name.
io::BurnedInIdentity identityIn(const DicomGround& ground)
{
    const core::View& view = ground.theCase.shown();
    const core::Mask2d letters =
        core::burnedInText(view.angiogram->frames[static_cast<std::size_t>(view.frame)], core::tellingLetterShare);
    const bool hasLetters = std::ranges::any_of(letters.pixels, [](std::uint8_t pixel) { return pixel != 0; });
    const bool mayBeThere = ground.wanted.look.identity == Identity::Shown || ground.angiogram.isAnnotated ||
                            hasLetters || namesPatient(ground.theCase.title, ground.angiogram);
    return mayBeThere ? io::BurnedInIdentity::MayBeThere : io::BurnedInIdentity::None;
}

/// One size and one scale of grey values for all frames; curves and residuals are those of one frame.
OverlayPictureOptions lookOfRun(const DicomGround& ground)
{
    OverlayPictureOptions look = ground.wanted.look;
    const core::View& view = ground.theCase.shown();
    look.isStartBeside = false;
    look.coloring = OverlayColoring::Branches;
    look.radiograph = nullptr;
    look.widthPx = look.widthPx > 0 ? look.widthPx : view.angiogram->width();
    if (!look.range) {
        look.range = core::displayRange(view.angiogram->frames[static_cast<std::size_t>(view.frame)]);
    }
    return look;
}

}   // namespace

core::Result<std::string> pictureObject(const DicomGround& ground)
{
    auto picture = drawOverlay(ground.theCase, ground.target, ground.wanted.look);
    if (!picture) {
        return picture.error();
    }
    return io::secondaryCapture({{std::move(picture).value()}, 0.0, identityIn(ground), says::dicomDerivation().text()},
                                ground.angiogram, ground.origin);
}

core::Result<std::string> runObject(const DicomGround& ground)
{
    const core::Angiogram& run = *ground.theCase.shown().angiogram;
    MoviePlan plan;
    plan.frames = {0, run.frameCount() - 1};
    plan.followed = core::framesOf(ground.theCase.shown().followed);
    OverlayPictureOptions look = lookOfRun(ground);
    const MovieSteps steps(ground.theCase, plan, look.shape);
    io::CapturedPictures captured{{}, run.frameTimeMs, identityIn(ground), says::dicomDerivation().text()};
    for (std::size_t i = 0; i < steps.count(); ++i) {
        if (ground.goesOn(static_cast<double>(i) / static_cast<double>(steps.count())) == core::Verdict::Stop) {
            return core::Error(core::Stopped{says::dicomStopped()});
        }
        const MovieStep step = steps.at(i);
        look.words = step.words;
        auto picture = drawOverlay(step.theCase, {}, look);
        if (!picture) {
            return picture.error();
        }
        captured.pictures.push_back(std::move(picture).value());
    }
    return io::secondaryCaptureRun(std::move(captured), ground.angiogram, ground.origin);
}

}   // namespace angiopose::app
