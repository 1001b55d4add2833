#include "app/review/radiograph_controller.h"

#include "ui/main_window.h"
#include "ui/theme/theme.h"
#include "ui/views/angiogram_view.h"
#include "ui/words/core_texts.h"

#include <QImage>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double opaqueShare = 0.85;   // of the strongest vessel: the angiogram shows through

/// Bright places in the colour of what is selected, dark ones clear.
QImage tinted(const core::ImageF& picture, const ui::Color& tone)
{
    QImage image(picture.width, picture.height, QImage::Format_ARGB32_Premultiplied);
    const float strongest = picture.pixels.empty() ? 1.0F : std::max(1e-6F, *std::ranges::max_element(picture.pixels));
    for (int y = 0; y < picture.height; ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < picture.width; ++x) {
            const double share = std::sqrt(std::max(0.0F, picture.at(x, y)) / strongest);
            row[x] = qPremultiply(
                qRgba(tone.red, tone.green, tone.blue, static_cast<int>(std::lround(255.0 * opaqueShare * share))));
        }
    }
    return image;
}

}   // namespace

RadiographController::RadiographController(const Parts& parts, QObject* parent) : QObject(parent), on_(parts)
{
    connect(&on_.look, &LookController::radiographWanted, this, &RadiographController::setWanted);
    connect(&on_.document, &CaseDocument::changed, this, &RadiographController::followDocument);
    connect(&on_.target, &TargetProvider::changed, this, &RadiographController::followDocument);
    connect(&on_.sync, &ViewSync::poseShown, this, [this](const core::RigidTransform& cameraFromPatient) {
        if (isWanted_ && isReady_) {
            job_.request(cameraFromPatient);
        }
    });
    connect(&job_, &RadiographJob::made, this, &RadiographController::show);
    connect(&job_, &RadiographJob::failed, this,
            [this](const QString& reason) { on_.window.strip().showStatus(ui::coreText(reason.toStdString())); });
}

void RadiographController::setWanted(bool wanted)
{
    isWanted_ = wanted;
    if (wanted) {
        followDocument();
        if (isReady_) {
            job_.request(on_.document.current().cameraFromPatient);
        }
    } else {
        clear();
    }
}

void RadiographController::clear()
{
    job_.clear();
    isReady_ = false;
    tree_.reset();
    volume_.reset();
    on_.window.angiogramView().setRadiograph({});
}

void RadiographController::followDocument()
{
    const core::RegistrationCase& current = on_.document.current();
    const auto camera = core::cameraOf(current);
    const std::optional<core::ProjectionCamera> known = camera ? std::optional(camera.value()) : std::nullopt;
    const bool isSame = isReady_ && current.tree == tree_ && current.volume == volume_ && known == camera_ &&
                        current.excludedBranchIds == excluded_;
    if (isReady_ && !(current.tree && current.angiogram)) {
        clear();
    }
    if (!isWanted_ || isSame || !on_.target.current()) {
        return;
    }
    auto input = core::registrationInputOf(current, *on_.target.current());
    if (!input) {
        clear();
        return;
    }
    isReady_ = true;
    tree_ = current.tree;
    volume_ = current.volume;
    camera_ = known;
    excluded_ = current.excludedBranchIds;
    job_.setInput(std::move(input).value(), current.options);
    job_.request(current.cameraFromPatient);
}

void RadiographController::show(const core::ImageF& picture)
{
    if (isWanted_) {
        on_.window.angiogramView().setRadiograph(
            tinted(picture, ui::branchColors(ui::palette(ui::ThemeMode::Dark)).auxiliary));
    }
}

}   // namespace app
