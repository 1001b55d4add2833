#include "app/review/snapshot_controller.h"

#include "app/document/edit_case.h"
#include "app/texts/pose_origin.h"
#include "app/words/snapshot_texts.h"
#include "core/support/utc_time.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

bool isSnapshotPose(const core::RigidTransform& a, const core::RigidTransform& b)
{
    return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() < 1e-9;
}

/// Returns the newest snapshot saved by the user, otherwise the newest one from a registration. Skips snapshots equal
/// to the current pose, since a comparison with these would show no difference.
std::optional<int> snapshotToCompare(const core::View& view)
{
    std::optional<int> ofRun;
    for (auto each = view.snapshots.rbegin(); each != view.snapshots.rend(); ++each) {
        if (isSnapshotPose(each->cameraFromPatient, view.cameraFromPatient)) {
            continue;
        }
        if (each->kind == core::SnapshotKind::Saved) {
            return each->id;
        }
        ofRun = ofRun ? ofRun : std::optional(each->id);
    }
    return ofRun;
}

/// Returns the first unused name of the form "Pose 4".
QString freeName(const std::vector<core::PoseSnapshot>& snapshots)
{
    for (int number = 1;; ++number) {
        QString name = SnapshotController::tr("Pose %1").arg(number);
        if (std::ranges::find(snapshots, name.toStdString(), &core::PoseSnapshot::name) == snapshots.end()) {
            return name;
        }
    }
}

}   // namespace

SnapshotController::SnapshotController(CaseDocument& document, PosePreview& preview, ui::WindowActions& actions,
                                       ui::SnapshotPanel& panel, ui::BottomStrip& strip, QObject* parent)
    : QObject(parent), document_(document), preview_(preview), actions_(actions), panel_(panel), strip_(strip)
{
    connectWindow();
    ui::keepTranslated(this, [this] { panel_.showSnapshots(document_.current().shown().snapshots); });
    connect(&document_, &CaseDocument::changed, this, &SnapshotController::updateFromDocument);
    connect(&preview_, &PosePreview::replaced, this, [this](PreviewSource whose) {
        if (whose == PreviewSource::Snapshot) {
            showCurrentPose();
        }
    });
}

void SnapshotController::connectWindow()
{
    ui::SnapshotPanel& panel = panel_;
    connect(&panel, &ui::SnapshotPanel::snapshotRequested, this, &SnapshotController::saveSnapshot);
    connect(&panel, &ui::SnapshotPanel::snapshotPicked, this, &SnapshotController::show);
    connect(&panel, &ui::SnapshotPanel::restoreRequested, this, &SnapshotController::restore);
    // Queued, because the slot refills the list while its editor is still active.
    connect(&panel, &ui::SnapshotPanel::renamed, this, &SnapshotController::rename, Qt::QueuedConnection);
    connect(&panel, &ui::SnapshotPanel::removeRequested, this, &SnapshotController::remove);
    connect(&panel, &ui::SnapshotPanel::markRequested, this, &SnapshotController::mark);
    connect(actions_[ui::Command::TakeSnapshot], &QAction::triggered, this, &SnapshotController::saveSnapshot);
    connect(actions_[ui::Command::ToggleSnapshots], &QAction::triggered, this, &SnapshotController::toggleAB);
}

void SnapshotController::setEvaluation(const SharedEvaluation& evaluation)
{
    evaluation_ = evaluation;
    if (metricsOfPose()) {
        emit poseEvaluated();
    }
}

const core::PoseSnapshot* SnapshotController::find(int snapshotId) const
{
    return core::findSnapshot(document_.current().shown().snapshots, snapshotId);
}

std::optional<core::SnapshotMetrics> SnapshotController::metricsOfPose() const
{
    const core::Case& current = document_.current();
    if (const core::RegistrationResult* const result = core::resultOfShownFrame(current.shown())) {
        return core::metricsOf(*result);
    }
    if (evaluation_ && isSnapshotPose(evaluation_->result.cameraFromPatient, current.shown().cameraFromPatient)) {
        core::RegistrationResult evaluated = evaluation_->result;
        addRegistrationResult(evaluated, current.shown());
        return core::metricsOf(evaluated);
    }
    return std::nullopt;
}

void SnapshotController::saveSnapshot()
{
    const core::Case& current = document_.current();
    if (!current.vessels.tree || !current.shown().angiogram) {
        strip_.showStatus(tr("There is no pose to save yet."));
        return;
    }
    core::PoseSnapshot kept;
    kept.name = freeName(current.shown().snapshots).toStdString();
    kept.author = observerName().toStdString();
    kept.time = core::utcNow();
    kept.method = current.shown().result ? current.shown().result->method : std::string();
    kept.frame = current.shown().frame;
    kept.cameraFromPatient = current.shown().cameraFromPatient;
    kept.metrics = metricsOfPose();
    kept.runMs = current.shown().result ? current.shown().result->time.totalMs : 0.0;
    const QString name = QString::fromStdString(kept.name);
    kept.kind = core::SnapshotKind::Saved;
    push(core::withSnapshot(current.shown().snapshots, kept), [name] { return tr("Save snapshot %1").arg(name); });
    marks_.b.reset();   // makes the next comparison use the new snapshot
    showsB_ = false;
    showMarks();
    strip_.showStatus(tr("Saved as “%1” · Y to compare").arg(name));
}

void SnapshotController::push(std::vector<core::PoseSnapshot> snapshots, const ui::LocalizedText& name)
{
    document_.push(std::make_unique<ChangeSnapshots>(document_, ChangeSnapshots::Values{std::move(snapshots)}, name));
}

void SnapshotController::show(int snapshotId)
{
    const core::PoseSnapshot* snapshot = find(snapshotId);
    if (!snapshot || document_.isLocked()) {
        showCurrentPose();
        return;
    }
    emit snapshotShown();
    preview_.show(PreviewSource::Snapshot, snapshot->cameraFromPatient, ResidualColors::Hidden);
    marks_.shown = snapshotId;
    showMarks();
    const QString name = QString::fromStdString(snapshot->name);
    strip_.showStatus(
        snapshot->metrics
            ? tr("“%1”: median %2 mm · Esc to return").arg(name).arg(ui::numberText(snapshot->metrics->medianMm, 2))
            : tr("“%1” · Esc to return").arg(name));
}

void SnapshotController::showCurrentPose()
{
    if (std::exchange(marks_.shown, std::nullopt)) {
        preview_.end(PreviewSource::Snapshot);
        showMarks();
    }
}

void SnapshotController::toggleAB()
{
    const auto& snapshots = document_.current().shown().snapshots;
    if (snapshots.empty()) {
        strip_.showStatus(tr(
            "There is nothing to compare with yet: press K to save a snapshot; each registration (R) also adds one."));
        return;
    }
    if (!marks_.b) {
        const std::optional<int> other = snapshotToCompare(document_.current().shown());
        if (!other) {
            strip_.showStatus(
                tr("There is nothing to compare with yet: press K to save a snapshot; each registration (R) also adds "
                   "one."));
            return;
        }
        mark(*other, false);
    }
    showsB_ = !showsB_;
    const std::optional<int> side = showsB_ ? marks_.b : marks_.a;
    if (side) {
        show(*side);
    } else {
        showCurrentPose();
        strip_.showStatus(tr("A: current pose"));
    }
}

void SnapshotController::mark(int snapshotId, bool isA)
{
    (isA ? marks_.a : marks_.b) = snapshotId;
    if (marks_.a == marks_.b) {
        (isA ? marks_.b : marks_.a).reset();
    }
    showsB_ = false;
    showMarks();
}

void SnapshotController::restore(int snapshotId)
{
    if (const core::PoseSnapshot* snapshot = find(snapshotId)) {
        const core::RigidTransform pose = snapshot->cameraFromPatient;
        document_.push(std::make_unique<MovePose>(
            document_, MovePose::Values{pose, std::nullopt, {}},
            [name = QString::fromStdString(snapshot->name)] { return tr("Restore %1").arg(name); }));
    }
}

void SnapshotController::rename(int snapshotId, const QString& name)
{
    if (const core::PoseSnapshot* snapshot = find(snapshotId)) {
        core::PoseSnapshot edited = *snapshot;
        edited.name = name.trimmed().toStdString();
        change(edited);
    }
}

void SnapshotController::change(const core::PoseSnapshot& edited)
{
    std::vector<core::PoseSnapshot> snapshots = document_.current().shown().snapshots;
    const auto found = std::ranges::find(snapshots, edited.id, &core::PoseSnapshot::id);
    if (found == snapshots.end()) {
        return;
    }
    const bool hasName = !edited.name.empty();
    found->name = hasName ? edited.name : found->name;
    found->author = edited.author;
    found->note = edited.note;
    found->kind = core::SnapshotKind::Saved;   // an edited snapshot is kept when those of old registrations are removed
    push(std::move(snapshots), [] { return tr("Edit snapshot"); });
}

void SnapshotController::remove(const std::set<int>& snapshotIds)
{
    std::vector<core::PoseSnapshot> snapshots = document_.current().shown().snapshots;
    const auto count =
        std::erase_if(snapshots, [&](const core::PoseSnapshot& each) { return snapshotIds.contains(each.id); });
    if (count > 0) {
        push(std::move(snapshots),
             [count] { return count == 1 ? tr("Delete snapshot") : tr("Delete %1 snapshots").arg(count); });
    }
}

void SnapshotController::updateFromDocument()
{
    const auto& snapshots = document_.current().shown().snapshots;
    showCurrentPose();
    showsB_ = false;
    for (std::optional<int>* side : {&marks_.a, &marks_.b}) {
        if (*side && !find(**side)) {
            side->reset();
        }
    }
    std::vector<std::string> listed;
    listed.reserve(snapshots.size());
    for (const core::PoseSnapshot& each : snapshots) {
        listed.push_back(std::to_string(each.id) + "\n" + each.name + "\n" + each.author + "\n" + each.note);
    }
    if (std::exchange(shownRows_, listed) != listed) {   // skipped for most changes, which concern only the pose
        panel_.showSnapshots(snapshots);
    }
    showMarks();
}

void SnapshotController::showMarks()
{
    panel_.showMarks(marks_);
}

}   // namespace angiopose::app
