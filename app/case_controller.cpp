#include "app/case_controller.h"

#include "app/document/edit_case.h"
#include "app/files/assemble_case.h"
#include "app/settings.h"
#include "app/step_states.h"
#include "app/texts/geometry_state.h"
#include "app/window_layout.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/bind_tool.h"
#include "ui/views/tools/nudge_tool.h"
#include "ui/views/tree_view.h"
#include "ui/words/core_texts.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>

#include <algorithm>

namespace app {

using namespace std::chrono_literals;

namespace {

/// Four rows of four numbers, as spreadsheets and scripts take them.
QString matrixText(const core::RigidTransform& transform)
{
    const Eigen::Matrix4d matrix = transform.matrix();
    QString text;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            text += QString::number(matrix(row, column), 'g', 12) + QLatin1Char(column < 3 ? '\t' : '\n');
        }
    }
    return text;
}

QString studyLine(const core::RegistrationCase& current)
{
    if (!current.angiogram) {
        return {};
    }
    const core::StudyIdentity& identity = current.angiogram->identity;
    QStringList parts;
    for (const std::string& part : {identity.studyDate, identity.modality}) {
        if (!part.empty()) {
            parts << QString::fromStdString(part);
        }
    }
    const int count = current.angiogram->frameCount();
    parts << (count > 1 ? CaseController::tr("%1 frames").arg(count) : CaseController::tr("1 frame"));
    return parts.join(QStringLiteral(" · "));
}

}   // namespace

CaseController::CaseController(ui::MainWindow& window, QObject* parent)
    : QObject(parent),
      window_(window),
      notices_(window, [this] { return registration_.isRunning() || session_.isLoading() || tracing_.isRunning(); }),
      sync_(window, document_),
      branches_(document_),
      pose_(document_),
      landmarks_(document_, window),
      start_(document_, window),
      angiogram_({document_, target_, sync_, window, notices_}),
      registration_(document_, target_),
      session_(window, document_, target_, registration_, notices_),
      review_(document_, sync_, window),
      look_(document_, sync_, window),
      replay_(document_, sync_, window),
      judgement_({document_, target_, pose_, registration_, sync_, look_, replay_, window}),
      slices_(document_, branches_, window),
      tracing_(document_, window),
      treeActions_(document_, branches_, tracing_, window),
      poses_({document_, target_, branches_, session_, review_, replay_, judgement_, sync_, notices_, window}),
      habits_(branches_, window),
      help_(window)
{
    connectEditing();
    connectBranches();
    connectPose();
    connectReview();
    connectGeometry();
    connectRegistration();
    connectHelp();
    connect(&document_, &CaseDocument::changed, this, &CaseController::followDocument);
    connect(&target_, &TargetProvider::changed, this, &CaseController::followTarget);
    connect(&session_, &SessionController::exported, this, [this] {
        exported_ = true;
        showSteps();
    });
    clock_.setInterval(5s);
    connect(&clock_, &QTimer::timeout, this, [this] { window_.strip().showSaveState(session_.saving().saveState()); });
    clock_.start();
    restoreWindowLayout(window_);
    followDocument();
}

void CaseController::connectEditing()
{
    QUndoStack& stack = document_.undoStack();
    QAction* undo = window_.actions()[ui::Command::Undo];
    QAction* redo = window_.actions()[ui::Command::Redo];
    connect(undo, &QAction::triggered, &document_, &CaseDocument::undo);
    connect(redo, &QAction::triggered, &document_, &CaseDocument::redo);
    const auto showHistory = [this, undo, redo, &stack] {
        const bool canUndo = document_.canUndo();
        undo->setEnabled(canUndo);
        redo->setEnabled(stack.canRedo());
        undo->setText(canUndo ? tr("Undo: %1").arg(stack.undoText()) : tr("Undo"));
        redo->setText(stack.canRedo() ? tr("Redo: %1").arg(stack.redoText()) : tr("Redo"));
        window_.strip().showUndoState(canUndo ? tr("Undo: %1").arg(stack.undoText()) : QString());
        showTitle();
    };
    connect(&stack, &QUndoStack::indexChanged, this, showHistory);
    connect(&document_, &CaseDocument::stateChanged, this, showHistory);
    connect(&stack, &QUndoStack::cleanChanged, this, &CaseController::showTitle);
    connect(&document_, &CaseDocument::editRefused, this,
            [this] { notices_.showNote(tr("A registration is running. Stop it to edit.")); });
    showHistory();
}

void CaseController::connectBranches()
{
    ui::BranchPanel& panel = window_.branches();
    connect(&branches_, &BranchController::marksChanged, this, [this] { sync_.showMarks(branches_.marks()); });
    connect(&branches_, &BranchController::refused, &notices_, &Notices::showNote);
    connect(&treeActions_, &TreeActions::refused, &notices_, &Notices::showNote);
    connect(&treeActions_, &TreeActions::adviceChanged, this, &CaseController::showSteps);
    connect(&tracing_, &TracingController::traced, &notices_, &Notices::showNote);
    connect(&tracing_, &TracingController::failed, this,
            [this](const QString& reason) { notices_.showProblem(tr("Vessels cannot be traced"), reason); });
    connect(&panel, &ui::BranchPanel::hovered, &branches_, &BranchController::hover);
    connect(&panel, &ui::BranchPanel::selectionEdited, &branches_, &BranchController::select);
    connect(&panel, &ui::BranchPanel::auxiliaryToggled, &branches_, &BranchController::toggleAuxiliary);
    connect(&panel, &ui::BranchPanel::excludedToggled, &branches_, &BranchController::toggleExcluded);
    connect(&panel, &ui::BranchPanel::onlyTheseAuxiliary, &branches_, &BranchController::setAuxiliary);
    connect(&panel, &ui::BranchPanel::auxiliaryCleared, this, [this] { branches_.setAuxiliary({}); });
    connect(&window_.angiogramView(), &ui::AngiogramView::branchHovered, &branches_, &BranchController::hover);
    connect(&window_.angiogramView(), &ui::AngiogramView::branchClicked, &branches_, &BranchController::click);
    connect(&window_.angiogramView(), &ui::AngiogramView::backgroundClicked, this, [this] { branches_.select({}); });
    connect(&window_.treeView(), &ui::TreeView::backgroundClicked, this, [this] { branches_.select({}); });
    connect(&window_.treeView(), &ui::TreeView::branchHovered, &branches_, &BranchController::hover);
    connect(&window_.treeView(), &ui::TreeView::branchClicked, &branches_, &BranchController::click);

    ui::WindowActions& actions = window_.actions();
    connect(actions[ui::Command::ToggleAuxiliary], &QAction::triggered, this,
            [this] { branches_.toggleAuxiliary(branches_.marks().selected); });
    connect(actions[ui::Command::ToggleExcluded], &QAction::triggered, this,
            [this] { branches_.toggleExcluded(branches_.marks().selected); });
    connect(actions[ui::Command::AuxiliaryWide], &QAction::triggered, &branches_, &BranchController::setAuxiliaryWide);
    connect(actions[ui::Command::AuxiliaryInView], &QAction::triggered, this, [this] {
        const ui::OverlayScene& scene = window_.angiogramView().scene();
        std::map<int, ui::ViewRect> extents;
        for (const core::VesselBranch& branch :
             document_.current().tree ? document_.current().tree->branches : std::vector<core::VesselBranch>{}) {
            if (const auto extent = scene.extentOf(branch.id)) {
                extents[branch.id] = *extent;
            }
        }
        branches_.setAuxiliaryInside(extents, window_.angiogramView().visiblePart());
    });
    connect(actions[ui::Command::SelectAll], &QAction::triggered, &branches_, &BranchController::selectAll);
}

void CaseController::connectPose()
{
    ui::PosePanel& panel = window_.pose();
    ui::AngiogramView& view = window_.angiogramView();
    connect(&panel, &ui::PosePanel::offsetEdited, &pose_, &PoseController::setOffset);
    connect(&panel, &ui::PosePanel::locksEdited, &pose_, &PoseController::setLocks);
    connect(&panel, &ui::PosePanel::resetRequested, &pose_, &PoseController::reset);
    connect(window_.actions()[ui::Command::ResetPose], &QAction::triggered, &pose_, &PoseController::reset);
    connect(&window_, &ui::MainWindow::escapePressed, &review_, &ReviewController::stopMotion);
    auto* tool = new ui::NudgeTool(view);
    ui::bindTool(*window_.actions()[ui::Command::Nudge], view, *tool);
    connect(tool, &ui::NudgeTool::keyNudged, this, [this](const ui::Nudge& nudge) {
        review_.stopMotion();
        window_.pose().setActiveAxis(nudge.axis);
        pose_.nudge(nudge);
    });
    connect(window_.actions()[ui::Command::Nudge], &QAction::toggled, this, [this](bool on) {
        review_.stopMotion();
        window_.pose().showNudgeMode(on);
        window_.pose().setActiveAxis(std::nullopt);
        notices_.showNote(on ? tr("Nudge mode: arrows move, drag moves or rolls, N ends") : tr("Nudge mode off"));
    });
    connect(tool, &ui::NudgeTool::dragStarted, &pose_, &PoseController::startDrag);
    connect(tool, &ui::NudgeTool::dragged, &pose_, &PoseController::drag);
    connect(tool, &ui::NudgeTool::dragFinished, &pose_, &PoseController::finishDrag);
    connect(tool, &ui::NudgeTool::dragCancelled, &pose_, &PoseController::cancelDrag);
    connect(&pose_, &PoseController::previewed, this, [this](const core::RigidTransform& pose) {
        sync_.showPreview(pose, ResidualColors::Kept);
        window_.pose().showOffset(pose_.currentOffset());
        judgement_.judge(pose);
    });
    connect(&pose_, &PoseController::previewEnded, this, [this] {
        sync_.endPreview();
        window_.pose().showOffset(pose_.currentOffset());
        judgement_.judge(document_.current().cameraFromPatient);
    });
    connect(&pose_, &PoseController::refused, &notices_, &Notices::showNote);
    connect(window_.actions()[ui::Command::CopyPose], &QAction::triggered, this, [this] {
        QGuiApplication::clipboard()->setText(matrixText(document_.current().cameraFromPatient));
        notices_.showNote(tr("Copied: camera from patient, 4 × 4, mm"));
    });
}

void CaseController::connectReview()
{
    connect(&landmarks_, &LandmarkController::refused, &notices_, &Notices::showNote);
    connect(&landmarks_, &LandmarkController::placed, &notices_, &Notices::showNote);
    connect(&start_, &StartPoseController::refused, &notices_, &Notices::showNote);
    connect(&start_, &StartPoseController::done, &notices_, &Notices::showNote);
    connect(&look_, &LookController::branchWanted, &branches_, [this](int branchId) { branches_.select({branchId}); });
    connect(&replay_, &ReplayController::solutionShown, &review_, &ReviewController::stopMotion);
    connect(&window_, &ui::MainWindow::escapePressed, &replay_, &ReplayController::showItself);
}

void CaseController::connectGeometry()
{
    connect(&window_.geometryPanel(), &ui::GeometryPanel::edited, this,
            [this](const core::CArm& cArm, const QString& what) {
                document_.push(
                    changeGeometry(document_, withGeometry(document_.current(), cArm), tr("Change %1").arg(what)));
            });
    connect(&window_.geometryPanel(), &ui::GeometryPanel::cameraOverrideDropped, this, [this] {
        core::RegistrationCase wanted = document_.current();
        wanted.cameraOverride.reset();
        wanted.result.reset();
        document_.push(changeGeometry(document_, wanted, tr("Use distances and spacing")));
    });
}

void CaseController::connectRegistration()
{
    ui::RegistrationPanel& panel = window_.registration();
    connect(&panel, &ui::RegistrationPanel::registerRequested, &registration_, &RegistrationController::start);
    connect(&panel, &ui::RegistrationPanel::stopRequested, &registration_, &RegistrationController::stop);
    connect(window_.actions()[ui::Command::Register], &QAction::triggered, this, [this] {
        if (!registration_.isRunning()) {
            review_.stopMotion();
            registration_.start();
        }
    });
    connect(window_.actions()[ui::Command::Stop], &QAction::triggered, &registration_, &RegistrationController::stop);
    connect(&window_.strip(), &ui::BottomStrip::stopRequested, this, [this] {
        registration_.stop();
        session_.abandonLoading();
    });
    connect(&panel, &ui::RegistrationPanel::optionsEdited, this,
            [this](const core::RegistrationOptions& options, const QString& label) {
                document_.push(std::make_unique<ChangeOptions>(document_, ChangeOptions::Values{options},
                                                               tr("Change option “%1”").arg(label)));
            });
    connect(&registration_, &RegistrationController::runningChanged, this, &CaseController::setRunning);
    connect(&registration_, &RegistrationController::tracingStarted, this,
            [this] { window_.strip().showBusy(tr("Tracing the vessels of this frame …")); });
    connect(&registration_, &RegistrationController::advanced, this, &CaseController::showProgress);
    connect(&registration_, &RegistrationController::finished, this, &CaseController::showFinished);
    connect(&registration_, &RegistrationController::failed, this,
            [this](const QString& reason) { notices_.showProblem(tr("Registration cannot run"), reason); });
}

void CaseController::followDocument()
{
    exported_ = false;
    sync_.refresh();
    branches_.followDocument();
    target_.want(document_.current());
    window_.pose().showOffset(pose_.currentOffset());
    window_.pose().showLocks(pose_.locks());
    window_.registration().showOptions(document_.current().options);
    window_.registration().showReady(registration_.whyNotReady());
    judgement_.judge(document_.current().cameraFromPatient);
    judgement_.show();
    window_.geometryPanel().showGeometry(geometryState(document_.current()));
    showTitle();
    showSteps();
}

void CaseController::followTarget()
{
    sync_.showTarget(target_.current());
    judgement_.judge(document_.current().cameraFromPatient);
    showSteps();
}

void CaseController::setRunning(bool running)
{
    review_.stopMotion();
    window_.registration().setRunning(running);
    window_.pose().setEnabled(!running);
    window_.geometryPanel().setEnabled(!running);
    if (running) {
        window_.result().startRun();
        sync_.showJudgement(nullptr);
    } else {
        sync_.endPreview();
        window_.strip().showIdle(tr("Ready"));
        judgement_.show();
    }
    showSteps();
}

void CaseController::showProgress(const core::IterationReport& report)
{
    if (!registration_.isRunning()) {
        return;   // a report that was still on its way when the run ended
    }
    sync_.showPreview(report.cameraFromPatient, ResidualColors::Kept);
    window_.result().showProgress(report);
    window_.strip().showProgress(tr("Registering: %1 · %2 % · %3 px")
                                     .arg(ui::coreText(report.stage))
                                     .arg(100.0 * report.progress, 0, 'f', 0)
                                     .arg(report.medianDistancePx, 0, 'f', 1),
                                 report.progress);
}

void CaseController::showFinished(const core::RegistrationResult& result)
{
    window_.steps().showCurrent(ui::Step::Review);
    notices_.showNote(result.stopReason == core::StopReason::StoppedByUser
                          ? tr("Stopped: the best pose so far is kept, undo takes it back")
                          : tr("Registered: median %1 mm").arg(result.metrics.medianMm, 0, 'f', 2));
}

void CaseController::connectHelp()
{
    ui::WindowActions& actions = window_.actions();
    connect(actions[ui::Command::About], &QAction::triggered, this, [this] {
        ui::MessageDialog::show(
            {tr("AngioPose %1").arg(QCoreApplication::applicationVersion()),
             tr("Finds where a 3-D vessel tree lies in a 2-D angiogram, without correspondences.\n\n"
                "Not for clinical use: AngioPose is a research program, not a medical device.\n\n"
                "Apache License 2.0. Built on Qt, VTK, ITK, OpenCV, NLopt, Eigen and nanoflann."),
             {}},
            &window_);
    });
    connect(&session_, &SessionController::noticeAccepted, &help_, &HelpController::offerTour);
    connect(&window_.steps(), &ui::StepBar::stepClicked, this, &CaseController::goToStep);
}

/// A step whose input is missing asks for it.
void CaseController::goToStep(ui::Step step)
{
    const core::RegistrationCase& current = document_.current();
    const bool asks =
        (step == ui::Step::Vessels && !current.tree) || (step == ui::Step::Angiogram && !current.angiogram);
    if (asks && !session_.isLoading()) {
        window_.actions()[ui::Command::Open]->trigger();
    } else {
        window_.focusStep(step);
    }
}

void CaseController::showTitle()
{
    const QString name = QString::fromStdString(document_.current().title);
    const QString star = document_.isModified() ? QStringLiteral("*") : QString();
    const QString shown = document_.isEmpty() ? QString() : (name.isEmpty() ? tr("Untitled case") : name) + star;
    window_.setWindowTitle(shown.isEmpty() ? tr("AngioPose · not for clinical use")
                                           : tr("%1 · AngioPose · not for clinical use").arg(shown));
    window_.header().showTitle(shown);
    window_.header().showStudy(studyLine(document_.current()));
    window_.strip().showSaveState(session_.saving().saveState());
}

void CaseController::showSteps()
{
    const core::RegistrationCase& current = document_.current();
    StepFacts facts;
    facts.targetProblem = ui::coreText(target_.problem());
    facts.isTracing = target_.isTracing();
    facts.isRunning = registration_.isRunning();
    facts.poseEdited = pose_.isMovedFromStart();
    facts.exported = exported_;
    facts.treePieces = treeActions_.advice().pieceCount();
    window_.steps().showStates(stepStates(current, facts));
}

}   // namespace app
