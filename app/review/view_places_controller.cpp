#include "app/review/view_places_controller.h"

#include "ui/places/folding_column.h"
#include "ui/places/view_frame.h"
#include "ui/slices/corner_views.h"
#include "ui/slices/slices_page.h"
#include "ui/views/angiogram_view.h"

namespace angiopose::app {

using ui::Command;
using ui::MovableView;

ViewPlacesController::ViewPlacesController(ui::MainWindow& window, QObject* parent) : QObject(parent), window_(window)
{
    connectAlone(Command::ImageOnly, MovableView::Image);
    connectAlone(Command::CornerOnly, MovableView::Corner);
    connectWindow(Command::ImageWindow, MovableView::Image);
    connectWindow(Command::CornerWindow, MovableView::Corner);
    connectWindow(Command::SlicesWindow, MovableView::Slices);
    connectSlices();
    connectFolding(Command::FoldLeft, ui::ColumnSide::Left);
    connectFolding(Command::FoldRight, ui::ColumnSide::Right);
    connect(window.actions()[Command::FullScreen], &QAction::toggled, this,
            [this](bool on) { window_.setWindowState(window_.windowState().setFlag(Qt::WindowFullScreen, on)); });
    ui::WindowActions& actions = window.actions();
    connect(&window.angiogramView(), &ui::AngiogramView::roomRequested, actions[Command::ImageOnly], &QAction::toggle);
    connect(&window.corner(), &ui::CornerViews::aloneRequested, actions[Command::CornerOnly], &QAction::toggle);
    connect(&window.corner(), &ui::CornerViews::windowRequested, actions[Command::CornerWindow], &QAction::toggle);
    connect(&window.slicesPage(), &ui::SlicesPage::windowRequested, actions[Command::SlicesWindow], &QAction::toggle);
}

void ViewPlacesController::connectAlone(Command command, MovableView view)
{
    QAction* alone = window_.actions()[command];
    connect(alone, &QAction::toggled, this, [this, view](bool on) { setAlone(view, on); });
    connect(&window_.frameOf(view), &ui::ViewFrame::outChanged, alone, [alone] { alone->setChecked(false); });
    connect(&window_, &ui::MainWindow::welcomeShown, alone, [alone] { alone->setChecked(false); });
}

void ViewPlacesController::connectWindow(Command command, MovableView view)
{
    QAction* out = window_.actions()[command];
    ui::ViewFrame& frame = window_.frameOf(view);
    out->setChecked(frame.isOut());
    connect(out, &QAction::toggled, &frame, &ui::ViewFrame::setOut);
    connect(&frame, &ui::ViewFrame::outChanged, out, &QAction::setChecked);
}

/// Connects the slice commands: slices in a separate window also count as large.
void ViewPlacesController::connectSlices()
{
    QAction* large = window_.actions()[Command::SlicesLarge];
    QAction* out = window_.actions()[Command::SlicesWindow];
    connect(out, &QAction::toggled, large, &QAction::setChecked);
    const auto follow = [large, out] { out->setEnabled(large->isEnabled()); };
    connect(large, &QAction::changed, out, follow);
    follow();
}

void ViewPlacesController::connectFolding(Command command, ui::ColumnSide side)
{
    QAction* fold = window_.actions()[command];
    ui::FoldingColumn& column = window_.column(side);
    connect(fold, &QAction::toggled, &column, &ui::FoldingColumn::setFolded);
    connect(&column, &ui::FoldingColumn::foldedChanged, fold, &QAction::setChecked);
}

/// Shows one view alone; if the view is in a separate window, makes that window full screen instead.
void ViewPlacesController::setAlone(MovableView view, bool on)
{
    ui::ViewFrame& frame = window_.frameOf(view);
    if (frame.isOut()) {
        frame.setFullScreen(on);
        return;
    }
    if (on) {
        const Command other = view == MovableView::Image ? Command::CornerOnly : Command::ImageOnly;
        if (!window_.frameOf(view == MovableView::Image ? MovableView::Corner : MovableView::Image).isOut()) {
            window_.actions()[other]->setChecked(false);
        }
    }
    window_.showAlone(on ? std::optional(view) : std::nullopt);
}

}   // namespace angiopose::app
