#include "app/review/solution_controller.h"

#include "app/messages/messages.h"
#include "app/texts/overlay_image.h"
#include "core/geometry/pose_difference.h"
#include "ui/panels/solution_strip.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <algorithm>

namespace angiopose::app {
namespace {

constexpr std::size_t maxSolutions = 9;

bool isSame(const std::vector<core::RigidTransform>& a, const std::vector<core::RigidTransform>& b)
{
    return std::ranges::equal(a, b, [](const core::RigidTransform& one, const core::RigidTransform& other) {
        return one.matrix() == other.matrix();
    });
}

/// Returns the pose itself followed by the alternatives; empty if there are no alternatives.
std::vector<core::RigidTransform> posesOf(const core::Case& current)
{
    std::vector<core::RigidTransform> poses;
    if (!current.shown().result || current.shown().result->alternatives.empty() || !current.vessels.tree ||
        !current.shown().angiogram) {
        return poses;
    }
    poses.push_back(current.shown().result->cameraFromPatient);
    for (const core::Hypothesis& other : current.shown().result->alternatives) {
        if (poses.size() < maxSolutions) {
            poses.push_back(other.cameraFromPatient);
        }
    }
    return poses;
}

/// Formats the branches of a path, e.g. "3 › 7 › 9"; for longer paths only the first and the last branch.
QString branchSequenceText(const core::WirePath& path)
{
    constexpr std::size_t maxNamed = 3;
    QStringList names;
    for (const int id : path.branchIds) {
        names.push_back(QString::number(id));
    }
    if (path.branchIds.size() > maxNamed) {
        names = {names.front(), QStringLiteral("…"), names.back()};
    }
    return names.join(QStringLiteral(" › "));
}

/// Lists the possible paths of a wire through the tree, one line per path.
std::vector<ui::SolutionRow> wirePathLines(const std::vector<core::WirePath>& paths, std::size_t count)
{
    std::vector<ui::SolutionRow> lines;
    for (std::size_t i = 0; i < std::min(count, paths.size()); ++i) {
        QStringList branches;
        for (const int id : paths[i].branchIds) {
            branches.push_back(QString::number(id));
        }
        const QString percent = ui::numberText(100.0 * paths[i].probability, 0);
        const QString label = SolutionController::tr(
                                  "Branches %1: probability %2 %; %3 % of the guidewire follows these branches, at a "
                                  "distance of %4 mm from their centerlines.")
                                  .arg(branches.join(QStringLiteral(", ")))
                                  .arg(percent)
                                  .arg(ui::numberText(100.0 * paths[i].followedShare, 0))
                                  .arg(ui::numberText(paths[i].offAxisMm, 1));
        lines.push_back({SolutionController::tr("%1 %: %2").arg(percent).arg(branchSequenceText(paths[i])),
                         i == 0 ? label : SolutionController::tr("%1 Press Enter to accept it.").arg(label)});
    }
    return lines;
}

std::vector<ui::SolutionRow> linesOf(const core::Case& current, std::size_t count)
{
    if (!current.shown().result->wirePaths.empty()) {
        return wirePathLines(current.shown().result->wirePaths, count);
    }
    std::vector<ui::SolutionRow> lines;
    const Eigen::Vector3d pivot = core::centroidInPatient(*current.vessels.tree);
    lines.push_back({SolutionController::tr("result"), SolutionController::tr("Registered solution")});
    for (std::size_t i = 1; i < count; ++i) {
        const core::Hypothesis& other = current.shown().result->alternatives[i - 1];
        const core::PoseDifference difference =
            core::differenceBetween(current.shown().result->cameraFromPatient, other.cameraFromPatient, pivot);
        lines.push_back(
            {SolutionController::tr("%1 mm, %2°")
                 .arg(ui::numberText(difference.inPlaneMm, 1))
                 .arg(ui::numberText(difference.rotationDeg, 1)),
             SolutionController::tr("Alternative solution %1, score %2: differs from the registered solution by %3 mm "
                                    "in plane, %4 mm in depth and %5° in rotation. Press Enter to accept it.")
                 .arg(i)
                 .arg(ui::numberText(other.score, 2))
                 .arg(ui::numberText(difference.inPlaneMm, 1))
                 .arg(ui::numberText(difference.depthMm, 1))
                 .arg(ui::numberText(difference.rotationDeg, 1))});
    }
    return lines;
}

}   // namespace

SolutionController::SolutionController(const CaseDocument& document, ui::SolutionStrip& strip, QObject* parent)
    : QObject(parent),
      document_(document),
      strip_(strip),
      drawingJob_([this](const Thumbnails& pictures) { showThumbnails(pictures); })
{
    ui::keepTranslated(this, [this] {
        shownPoses_.clear();
        updateFromDocument();
    });
    connect(&document_, &CaseDocument::changed, this, &SolutionController::updateFromDocument);
    connect(&strip, &ui::SolutionStrip::solutionPicked, this,
            [this](int index) { emit solutionSelected(static_cast<std::size_t>(index)); });
    connect(&strip, &ui::SolutionStrip::acceptRequested, this,
            [this](int index) { emit acceptRequested(static_cast<std::size_t>(index)); });
}

void SolutionController::showThumbnails(const Thumbnails& pictures)
{
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        strip_.showThumbnail(static_cast<int>(i), pictures[i]);
    }
}

void SolutionController::showCurrent(std::size_t index)
{
    strip_.showCurrent(static_cast<int>(index));
}

void SolutionController::updateFromDocument()
{
    std::vector<core::RigidTransform> poses = posesOf(document_.current());
    if (isSame(poses, shownPoses_)) {
        return;
    }
    shownPoses_ = std::move(poses);
    strip_.showSolutions(shownPoses_.empty() ? std::vector<ui::SolutionRow>{}
                                             : linesOf(document_.current(), shownPoses_.size()));
    draw(shownPoses_);
}

void SolutionController::draw(const std::vector<core::RigidTransform>& poses)
{
    drawingJob_.drop();   // abandons thumbnails of earlier poses
    if (poses.empty()) {
        return;
    }
    const int widthPx = strip_.thumbnailWidthPx();
    drawingJob_.start(
        [session = document_.current(), poses, widthPx](JobLink<double>& link) -> core::Result<Thumbnails> {
            core::Case snapshot = session;
            Thumbnails pictures;
            for (const core::RigidTransform& pose : poses) {
                if (link.decision() == core::ObserverDecision::Stop) {
                    break;
                }
                snapshot.shown().cameraFromPatient = pose;
                auto picture = drawThumbnail(snapshot, widthPx);
                if (!picture) {
                    break;
                }
                pictures.push_back(std::move(picture).value());
            }
            return pictures;
        });
}

}   // namespace angiopose::app
