#include "app/help/help_controller.h"

#include "app/help/fit_examples.h"
#include "app/preferences/settings.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/help/help_page.h"
#include "ui/help/tour.h"
#include "ui/main_window.h"
#include "ui/places/folding_column.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/gl_driver.h"
#include "ui/words/message_text.h"

#include <QApplication>
#include <QCursor>
#include <QImage>

namespace angiopose::app {

HelpController::HelpController(ui::MainWindow& window, QObject* parent) : QObject(parent), window_(window)
{
    const ui::WindowActions& actions = window.actions();
    connect(actions[ui::Command::PanelHelp], &QAction::triggered, this, &HelpController::showPage);
    connect(actions[ui::Command::Tour], &QAction::triggered, this, &HelpController::startTour);
    connect(actions[ui::Command::GoodFit], &QAction::triggered, this, &HelpController::showFitExamples);
    connect(actions[ui::Command::Messages], &QAction::triggered, this,
            [this] { (new ui::MessageHistory(window_.strip().reported(), &window_))->open(); });
    connect(actions[ui::Command::About], &QAction::triggered, this, &HelpController::showAbout);
}

/// Shows the help page of the widget under the mouse, or of the widget with keyboard focus if the mouse is outside the
/// window.
void HelpController::showPage()
{
    QWidget* pointed = QApplication::widgetAt(QCursor::pos());
    if (!pointed || pointed->window() != &window_) {
        pointed = QApplication::focusWidget();
    }
    (new ui::HelpPage(ui::HelpPage::pageAbout(pointed), tr("Help"), &window_))->open();
}

void HelpController::offerTour()
{
    if (!settings::isTourCompleted.read()) {
        startTour();
    }
}

void HelpController::startTour()
{
    if (tour_) {
        return;
    }
    settings::isTourCompleted.write(true);
    for (const ui::ColumnSide side :
         {ui::ColumnSide::Left, ui::ColumnSide::Right}) {   // the tour points only at visible panels
        window_.column(side).setFolded(false);
    }
    ui::TourStop start{&window_.angiogramView(), tr("Start here"),
                       tr("Drop a case, or vessels and an angiogram, anywhere in the window. “Open the sample case” "
                          "requires no data of your own.")};
    if (!window_.angiogramView().isVisible()) {   // without a case, the parts that the tour explains are hidden
        start.target = &window_.welcome();
        start.leaveLabel = tr("Open the sample case");
        start.onLeave = [this] { window_.actions()[ui::Command::OpenSample]->trigger(); };
    }
    tour_ = new ui::Tour(
        {start,
         {&window_.steps(), tr("Steps to a result"),
          tr("Each step shows a check mark when complete; otherwise, its tooltip lists what is missing. The steps can "
             "be clicked in any order.")},
         {&window_.branches(), tr("The vessel tree"),
          tr("Lists the branches with their lengths and residuals. Press A to add a branch to the auxiliary branches, "
             "X to exclude it.")},
         {&window_.angiogramView(), tr("The angiogram"),
          tr("The projected tree is overlaid on the angiogram and colored by its distance to the traced vessels. "
             "Wheel: scroll through the frames. N: move the tree with the arrow keys or the mouse. H: hide the tree.")},
         {&window_.registration(), tr("Register"),
          tr("R finds the pose. Stop keeps the best pose found so far; Ctrl+Z restores the pose from before the "
             "registration.")},
         {&window_.result(), tr("Is the result reliable?"),
          tr("Shows distances in mm and notes on what cannot be determined from this image. Shift+F1 shows examples of "
             "good and bad fits.")},
         {&window_.header(), tr("Getting help"),
          tr("F1 explains the item under the mouse pointer; ? lists all shortcuts and lets you change them. This tour "
             "is also available from the Help menu.")}},
        &window_);
}

void HelpController::showFitExamples()
{
    if (goodFit_) {
        return;
    }
    goodFit_ = new ui::GoodFit(&window_);
    goodFit_->open();
    for (int i = 0; i < ui::fitExampleCount; ++i) {
        loadFitExample(i);
    }
}

void HelpController::loadFitExample(int index)
{
    const auto example = static_cast<ui::FitExample>(index);
    exampleImages_.run([example] { return fitExampleImage(example); },
                       [this, example](const core::Result<QString>& path) {
                           if (!goodFit_) {
                               return;
                           }
                           if (path) {
                               goodFit_->showExample(example, QImage(path.value()));
                           } else {
                               goodFit_->showProblem(ui::messageText(path.error().message));
                           }
                       });
}

/// Describes the renderer and the OpenGL driver, for reports of display problems.
QString HelpController::rendererDescription() const
{
    const ui::GlDriver& driver = ui::glDriver();
    const QString renderer = ui::chosenRenderer() == ui::Renderer::Vtk
                                 ? tr("The angiogram is rendered with VTK (OpenGL).")
                                 : tr("The angiogram is rendered on the CPU.");
    return driver.isAvailable()
               ? QStringLiteral("%1\nOpenGL %2: %3, %4").arg(renderer, driver.version, driver.vendor, driver.renderer)
               : renderer;
}

void HelpController::showAbout()
{
    ui::MessageDialog::show({tr("AngioPose %1").arg(QCoreApplication::applicationVersion()),
                             tr("Registers a 3-D vessel tree to a 2-D angiogram without correspondences.\n\nNot for "
                                "clinical use: AngioPose is research software, not a medical device.\n\nApache License "
                                "2.0. Built on Qt, VTK, ITK, OpenCV, NLopt, Eigen and nanoflann."),
                             rendererDescription()},
                            &window_);
}

}   // namespace angiopose::app
