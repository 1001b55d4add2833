#include "app/review/scan_controller.h"

#include "app/preferences/settings.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/slices/corner_views.h"
#include "ui/slices/slice_model.h"
#include "ui/views/scan_bar.h"
#include "ui/views/tree_view.h"
#include "ui/words/message_text.h"
#include "ui/words/retranslation.h"

#include <algorithm>
#include <chrono>

namespace angiopose::app {
namespace {

using namespace std::chrono_literals;
using core::ScanPreset;
using ui::Command;

constexpr double aroundVesselsMm = 12.0;
constexpr int roughPx = 40'000;
constexpr int finePx = 1'500'000;   // more pixels than the view has beside the image at 200 % display scaling

core::Rgb toRgb(const ui::Color& color)
{
    const auto unit = color.unit();
    return {static_cast<float>(unit[0]), static_cast<float>(unit[1]), static_cast<float>(unit[2])};
}

bool isSame(const core::VolumePreparation& a, const core::VolumePreparation& b)
{
    const bool isSameBox = a.boxInPatient.has_value() == b.boxInPatient.has_value() &&
                           (!a.boxInPatient || a.boxInPatient->isApprox(*b.boxInPatient));
    return a.scan == b.scan && a.mask == b.mask && a.tree == b.tree && isSameBox;
}

}   // namespace

ScanController::ScanController(const CaseDocument& document, const Ui& ui, QObject* parent)
    : QObject(parent),
      document_(document),
      ui_(ui),
      preset_(static_cast<ScanPreset>(std::clamp(settings::scanPreset.read(), 0, 1))),
      strength_(std::clamp(settings::scanStrength.read(), 0.0, 1.0))
{
    connectCommands();
    ui_.corner.scanBar().showStrength(strength_);
    connect(&ui_.corner.scanBar(), &ui::ScanBar::strengthChanged, this, &ScanController::setStrength);
    connect(&ui_.slices, &ui::SliceModel::scanChanged, this, &ScanController::updateFromDocument);
    connect(&ui_.slices, &ui::SliceModel::maskChanged, this, &ScanController::updateFromDocument);
    connect(&ui_.slices, &ui::SliceModel::appearanceChanged, this, [this] {   // the colors of labels may have changed
        if (appearance() != requestedAppearance_) {
            requestRough();
        }
    });
    connect(&document, &CaseDocument::changed, this, &ScanController::updateFromDocument);
    connect(&ui_.treeView, &ui::TreeView::cameraChanged, this, &ScanController::requestRough);
    connect(&job_, &ScanJob::prepared, this, [this] {
        ui_.treeView.scene().setScanBox(job_.boxInPatient());
        ui_.treeView.requestRender();
        requestRough();
        showState();
    });
    connect(&job_, &ScanJob::failed, this, [this](const core::Message& reason) {
        ui_.strip.showStatus(ui::messageText(reason));
        showState();
    });
    connect(&job_, &ScanJob::rendered, this, &ScanController::show);
    idleTimer_.setSingleShot(true);
    idleTimer_.setInterval(180ms);
    connect(&idleTimer_, &QTimer::timeout, this, &ScanController::requestFine);
    ui::keepTranslated(this, [this] { showState(); });
    updateFromDocument();
}

void ScanController::connectCommands()
{
    ui::WindowActions& actions = ui_.actions;
    ui_.corner.scanBar().fillMenu({actions[Command::ScanIn3d], actions[Command::NextScanRendering],
                                   actions[Command::ScanAtVessels], actions[Command::ScanOnDetector]});
    actions[Command::ScanIn3d]->setChecked(settings::scanIn3d.read());
    actions[Command::ScanAtVessels]->setChecked(settings::scanAtVessels.read());
    connect(actions[Command::ScanIn3d], &QAction::toggled, this, [this](bool on) {
        settings::scanIn3d.write(on);
        if (on) {
            ui_.corner.showPlane(std::nullopt);   // switches to the 3-D view, in which the scan appears
        }
        updateFromDocument();
    });
    connect(actions[Command::ScanAtVessels], &QAction::toggled, this, [this](bool on) {
        settings::scanAtVessels.write(on);
        updateFromDocument();
    });
    connect(actions[Command::NextScanRendering], &QAction::triggered, this, [this] {
        preset_ = preset_ == ScanPreset::Vessels ? ScanPreset::VesselsAndBone : ScanPreset::Vessels;
        settings::scanPreset.write(static_cast<int>(preset_));
        ui_.actions[Command::ScanIn3d]->setChecked(true);   // choosing a preset implies showing the scan
        showState();
        requestRough();
    });
}

bool ScanController::isEnabled() const
{
    return ui_.slices.hasScan() && ui_.actions[Command::ScanIn3d]->isChecked();
}

core::VolumePreparation ScanController::volumeToShow() const
{
    core::VolumePreparation what{ui_.slices.volume(), ui_.slices.sharedMask(), nullptr};
    const auto& tree = document_.current().vessels.tree;
    const bool hasTree = tree && !tree->branches.empty();
    if (!what.mask) {
        what.tree = tree;
    }
    if (hasTree && ui_.actions[Command::ScanAtVessels]->isChecked()) {
        Eigen::AlignedBox3d box;
        for (const core::VesselBranch& branch : tree->branches) {
            for (const Eigen::Vector3d& point : branch.pointsInPatient) {
                box.extend(point);
            }
        }
        const Eigen::Vector3d margin = Eigen::Vector3d::Constant(aroundVesselsMm);
        what.boxInPatient = Eigen::AlignedBox3d(box.min() - margin, box.max() + margin);
    }
    return what;
}

void ScanController::updateFromDocument()
{
    for (const Command command : {Command::ScanIn3d, Command::NextScanRendering, Command::ScanAtVessels}) {
        ui_.actions[command]->setEnabled(ui_.slices.hasScan());
    }
    if (!isEnabled()) {
        releaseData();
    } else if (core::VolumePreparation what = volumeToShow(); !isSame(what, shownVolume_)) {
        shownVolume_ = what;
        job_.prepare(std::move(what), document_.current().vessels.input.tracing.threshold);
    }
    showState();
}

/// Releases all data if the scan is not shown.
void ScanController::releaseData()
{
    job_.clear();
    idleTimer_.stop();
    shownVolume_ = {};
    isShown_ = false;
    ui_.treeView.scene().setScanBox({});
    ui_.treeView.scene().setScanRendering({});
    ui_.treeView.requestRender();
}

core::AppearanceOptions ScanController::appearance() const
{
    const ui::ScanColors colors = ui::scanColors();
    core::AppearanceOptions options{preset_, strength_, toRgb(colors.softTissue), toRgb(colors.bone), {}};
    for (const ui::MaskTint& tint : ui_.slices.labelTints()) {
        options.kinds.push_back(toRgb(tint.color));
    }
    if (options.kinds.empty()) {
        options.kinds = {toRgb(colors.vessels)};
    }
    return options;
}

void ScanController::requestRough()
{
    if (request(appearance(), roughPx, ScanDetail::Rough)) {
        requestedAppearance_ = appearance();
        idleTimer_.start();
    }
}

void ScanController::requestFine()
{
    request(requestedAppearance_, finePx, ScanDetail::Fine);
}

bool ScanController::request(const core::AppearanceOptions& options, int maxPx, ScanDetail detail)
{
    if (!job_.isReady() || !ui_.treeView.isVisible()) {
        return false;
    }
    const core::ParallelProjection projection = ui_.treeView.scene().projection(maxPx);
    if (projection.isDefined()) {   // a view that cannot be drawn has no viewpoint
        job_.request({options, projection, detail});
    }
    return projection.isDefined();
}

void ScanController::show(const ScanRendering& picture)
{
    isShown_ = true;
    ui_.treeView.scene().setScanRendering({picture.projection, picture.pixels});
    ui_.treeView.requestRender();
}

void ScanController::showState()
{
    const bool isOn = isEnabled();
    const bool isMask = ui_.slices.volume() == nullptr;
    const QString appearance = isMask                           ? tr("labels")
                               : preset_ == ScanPreset::Vessels ? tr("vessels")
                               : !job_.isReady() || job_.isHu() ? tr("vessels and bone")
                                                                : tr("vessels and tissue");
    ui_.corner.scanBar().showState(isOn ? tr("Scan: %1").arg(appearance) : tr("Scan: off"), isOn);
}

void ScanController::setStrength(double strength)
{
    strength_ = strength;
    settings::scanStrength.write(strength);
    requestRough();
}

}   // namespace angiopose::app
