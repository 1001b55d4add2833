#include "app/case_controller.h"

#include "app/preferences/settings.h"
#include "ui/main_window.h"
#include "ui/words/retranslation.h"

#include <QCryptographicHash>
#include <QGuiApplication>
#include <QScreen>

namespace angiopose::app {
namespace {

/// Returns the settings key for the current screens and their arrangement.
QString screensKey()
{
    QByteArray text;
    for (const QScreen* screen : QGuiApplication::screens()) {
        const QRect place = screen->geometry();
        text += screen->name().toUtf8() + QByteArray::number(place.x()) + ',' + QByteArray::number(place.y()) + ',' +
                QByteArray::number(place.width()) + ',' + QByteArray::number(place.height()) + ',' +
                QByteArray::number(screen->devicePixelRatio()) + ';';
    }
    const QByteArray hash = QCryptographicHash::hash(text, QCryptographicHash::Sha1).toHex().left(12);
    return QStringLiteral("window/layouts/") + QString::fromLatin1(hash);
}

/// Restores the position, column widths and folded panels that the window had when it was last closed on the same set
/// of screens; for a new set, restores the most recent layout.
void restoreWindowLayout(ui::MainWindow& window)
{
    const QVariant here = QSettings().value(screensKey());
    const QByteArray layout = here.isValid() ? here.toByteArray() : settings::windowLayout.read();
    if (!layout.isEmpty()) {
        window.restoreLayout(layout);
    }
}

void storeWindowLayout(const ui::MainWindow& window)
{
    const QByteArray layout = window.layoutState();
    QSettings().setValue(screensKey(), layout);
    settings::windowLayout.write(layout);
}

}   // namespace

CaseController::CaseController(ui::MainWindow& window, QObject* parent)
    : QObject(parent),
      window_(window),
      notifications_(window.strip(), window,
                     [this] {
                         return registration_.isRunning() || session_.isLoading() || tracing_.isRunning() ||
                                session_.isWriting();
                     }),
      preview_(document_),
      sync_(document_, preview_,
            {window.angiogramView(), window.treeView(), window.slices(), window.branches(), window.registration(),
             window.strip()}),
      history_(document_, window.actions(), window.strip()),
      branches_(document_),
      picking_(document_, branches_, sync_,
               {window.actions(), window.branches(), window.angiogramView(), window.treeView()}),
      pose_(document_),
      pivot_(document_, {window.actions(), window.pose(), window.angiogramView(), window.treeView()}),
      landmarks_(document_,
                 {window.actions(), window.landmarks(), window.angiogramView(), window.treeView(), window.slices()}),
      measureController_(document_, sync_, preview_,
                         {window.actions(),
                          window.measure(),
                          window.angiogramView(),
                          {window.slices(), window.slicesPage(), window.corner()}}),
      marks_(document_, sync_, preview_,
             {window.actions(), window.marks(), window.angiogramView(), window.treeView(), window.slices()}),
      initialPose_(document_, window.actions()),
      geometry_(document_, window.geometryPanel()),
      angiogram_({document_, target_, sync_, notifications_, window.actions(), window.angiogramPanel(),
                  window.angiogramView(), window.strip(), window}),
      registration_(document_, target_),
      session_(document_, target_, registration_, preview_, notifications_,
               {window.actions(), window.welcome(), window.angiogramView(), window.strip(), window}),
      profile_(document_, branches_, session_.exportController(),
               {window.actions(), window.profile(), window.angiogramView(), window.treeView(), window.slices()}),
      title_(document_, session_.saveController(), window.header(), window.strip(), window),
      patient_(document_, window.patient(), *window.actions()[ui::Command::HideIdentity]),
      review_(document_, sync_, preview_,
              {window.actions(), window.angiogramView(), window.treeView(), window.strip()}),
      cine_(document_, sync_, review_, window.actions(), window.strip()),
      overlayStyle_(document_, sync_,
                    {window.actions(), window.angiogramPanel(), window.angiogramView(), window.strip()}),
      replayController_(document_, preview_, window.actions(), window.strip()),
      evaluationController_({document_, target_, pose_, registration_, sync_, overlayStyle_, replayController_,
                             window.result(), window.pose()}),
      gestures_({document_, pose_, review_, evaluationController_, preview_, notifications_, window.actions(),
                 window.pose(), window.registration(), window.angiogramView()}),
      runController_({document_, registration_, session_, review_, evaluationController_, sync_, preview_,
                      notifications_, window.actions(), window.registration(), window.result(), window.pose(),
                      window.geometryPanel(), window.treeView(), window.strip()}),
      slices_(document_, branches_,
              {window.actions(), window.slices(), window.slicesPage(), window.corner(), window.treeView()}),
      tracing_(document_, {window.actions(), window.tracing(), window.slices(), window.slicesPage(), window.strip()}),
      mask_(document_, [this] { return tracing_.draft(); },
            {window.actions(), window.tracing(), window.slices(), window.strip()}),
      paths_(document_, {window.actions(), window.tracing(), window.slices()}),
      treeActions_(document_, branches_, tracing_,
                   {window.actions(), window.branches(), window.treeView(), window.corner(), window.slices(),
                    window.slicesPage(), window}),
      steps_({document_, target_, pose_, registration_, treeActions_, session_, window}),
      poses_({document_, target_, branches_, session_, review_, replayController_, evaluationController_, preview_,
              notifications_, window.actions(), window.angiogramView(), window.result(), window.snapshots(),
              window.landmarks(), window.trialBar(), window.strip(), window}),
      viewPlacement_(window),
      layout_(registration_, window),
      views_(document_, target_, {window.actions(), window.views(), window.registration(), window}),
      sideBySide_({document_, preview_, branches_, overlayStyle_, views_},
                  {window.actions(), window.views(), window.sideBySide()}),
      crosshair_(document_, preview_,
                 {window.actions(), window.views(), window.sideBySide(), window.treeView(), window.slices()}),
      angles_(document_, branches_, window.actions(), window),
      trackingController_({document_, review_, sync_, preview_, session_.exportController(), notifications_,
                           window.actions(), window.result(), window.strip()}),
      movieController_({document_, target_, session_.exportController(), trackingController_, cine_, notifications_,
                        window.actions(), window.strip(), window}),
      drr_({document_, target_, sync_, overlayStyle_, window.angiogramView(), window.strip()}),
      scan_(document_, {window.actions(), window.treeView(), window.corner(), window.slices(), window.strip()}),
      detectorDrr_(document_, sync_, {window.actions(), window.treeView()}),
      preferences_(branches_, {window.actions(), window.angiogramView(), window.treeView(), window.strip(), window}),
      help_(window),
      support_(document_, {window.actions(), window.strip(), window.faultBar(), window})
{
    connectWindow();
    connectNotes();
    connectTracing();
    connectReview();
    connect(&document_, &CaseDocument::changed, this, &CaseController::updateFromDocument);
    connect(&target_, &TargetProvider::changed, this, &CaseController::updateFromTarget);
    connect(&session_, &SessionController::firstStarted, &help_, &HelpController::offerTour);
    restoreWindowLayout(window_);
    layout_.begin();
    ui::keepTranslated(this, [this] { updateFromDocument(); });
}

void CaseController::begin(const QStringList& paths)
{
    support_.reportCrash();
    session_.begin(paths);
}

bool CaseController::isBusy() const
{
    return registration_.isRunning() || session_.isLoading() || tracing_.isRunning() || mask_.isRunning() ||
           trackingController_.isRunning() || movieController_.isRunning() || session_.isWriting() || poses_.isBusy() ||
           views_.isSummarizing() || document_.isInTrial();
}

/// Connects the events of the main window: files, clicks, keys and closing.
void CaseController::connectWindow()
{
    connect(&window_, &ui::MainWindow::filesDropped, &session_, &SessionController::open);
    connect(&window_, &ui::MainWindow::closeRequested, &session_, &SessionController::closeWindow);
    connect(&session_, &SessionController::windowMayClose, this, [this] {
        layout_.remember();
        storeWindowLayout(window_);
        window_.closeNow();
    });
    connect(&window_, &ui::MainWindow::pointPicked, &pivot_, &PivotController::pickIfActive);
    connect(&window_, &ui::MainWindow::pointPicked, &landmarks_, &LandmarkController::pickPoint);
    connect(&window_, &ui::MainWindow::pointPicked, &marks_, &MarkController::pickPoint);
    connect(&window_, &ui::MainWindow::pointPicked, &treeActions_.tree(), &TreeController::setClickedPoint);
    connect(&window_, &ui::MainWindow::escapePressed, &tracing_, &TracingController::endPicking);
    connect(&window_, &ui::MainWindow::escapePressed, &review_, &ReviewController::stopMotion);
    connect(&window_, &ui::MainWindow::escapePressed, &replayController_, &ReplayController::showCurrentPose);
    connect(&window_, &ui::MainWindow::escapePressed, &poses_.snapshots(), &SnapshotController::showCurrentPose);
    connect(&window_, &ui::MainWindow::hideKeyToggled, &overlayStyle_, &OverlayStyleController::setHiddenWhileHeld);
    connect(&steps_, &StepController::stepSelected, &layout_, &StepLayoutController::goTo);
    connect(&slices_, &SliceController::largeChanged, &window_, &ui::MainWindow::setSlicesEnlarged);
}

/// Shows the reason for a failed edit in the status strip.
void CaseController::connectNotes()
{
    connect(&document_, &CaseDocument::editRefused, this,
            [this] { notifications_.showNote(tr("A registration is running. Stop it before editing.")); });
    connect(&branches_, &BranchController::refused, &notifications_, &Notifications::showNote);
    connect(&treeActions_, &TreeActions::refused, &notifications_, &Notifications::showNote);
    connect(&views_, &ViewController::refused, &notifications_, &Notifications::showNote);
    connect(&sideBySide_, &SideBySideController::reported, &notifications_, &Notifications::showNote);
    connect(&crosshair_, &LinkedCrosshair::reported, &notifications_, &Notifications::showNote);
    connect(&pivot_, &PivotController::reported, &notifications_, &Notifications::showNote);
    connect(&treeActions_, &TreeActions::pivotRequested, &pivot_, &PivotController::pick);
    connect(&landmarks_, &LandmarkController::refused, &notifications_, &Notifications::showNote);
    connect(&landmarks_, &LandmarkController::placed, &notifications_, &Notifications::showNote);
    connect(&profile_, &ProfileController::refused, &notifications_, &Notifications::showNote);
    connect(&marks_, &MarkController::refused, &notifications_, &Notifications::showNote);
    connect(&measureController_, &MeasureController::refused, &notifications_, &Notifications::showNote);
    connect(&initialPose_, &InitialPoseController::refused, &notifications_, &Notifications::showNote);
    connect(&initialPose_, &InitialPoseController::done, &notifications_, &Notifications::showNote);
}

void CaseController::connectTracing()
{
    connect(&tracing_, &TracingController::traced, &notifications_, &Notifications::showNote);
    connect(&session_.openController(), &OpenController::inputsAdded, &tracing_, &TracingController::setWarnings);
    connect(&tracing_, &TracingController::failed, this,
            [this](const QString& reason) { notifications_.showProblem(tr("Could not trace the vessels"), reason); });
    connect(&mask_, &MaskController::reported, &notifications_, &Notifications::showNote);
    connect(&mask_, &MaskController::failed, this,
            [this](const QString& reason) { notifications_.showProblem(tr("Could not trace the vessels"), reason); });
    connect(&paths_, &PathController::reported, &notifications_, &Notifications::showNote);
    connect(&paths_, &PathController::failed, &notifications_, &Notifications::showNote);
    connect(&session_.saveController(), &SaveController::saved, &mask_, &MaskController::noteSaved);
}

void CaseController::connectReview()
{
    connect(&movieController_, &MovieController::written, &session_.audit(),
            [this](const QString& path) { session_.audit().note(io::AuditEvent::Exported, {path}); });
    connect(&support_, &SupportController::written, &notifications_,
            [this](const QString& path) { notifications_.showNote(tr("Support bundle saved: %1").arg(path)); });
    connect(&support_, &SupportController::failed, &notifications_, [this](const QString& reason) {
        notifications_.showProblem(tr("Could not save the support bundle"), reason);
    });
    connect(&overlayStyle_, &OverlayStyleController::branchRequested, &branches_,
            [this](int branchId) { branches_.select({branchId}); });
    connect(&window_.registration(), &ui::RegistrationPanel::allViewsToggled, &preview_,
            &PosePreview::setMovesAllViews);
    connect(&replayController_, &ReplayController::solutionShown, &review_, &ReviewController::stopMotion);
}

void CaseController::updateFromDocument()
{
    sync_.refresh();
    showPage();
    branches_.updateFromDocument();
    target_.setCase(document_.current());
    gestures_.show();
    runController_.show();
    evaluationController_.evaluate(document_.current().shown().cameraFromPatient);
    evaluationController_.show();
    geometry_.show();
    steps_.show();
}

void CaseController::showPage()
{
    if (document_.isEmpty() && !document_.current().vessels.scan) {
        window_.showWelcomePage();
    } else {
        window_.showImagePage();
    }
}

void CaseController::updateFromTarget()
{
    sync_.showTarget(target_.current());
    evaluationController_.evaluate(document_.current().shown().cameraFromPatient);
    evaluationController_.show();   // shows the reason if the fit cannot be assessed
    steps_.show();
}

}   // namespace angiopose::app
