#include "app/review/view_placement_controller.h"

#include "ui/places/folding_column.h"
#include "ui/places/view_frame.h"
#include "ui/slices/corner_views.h"
#include "ui/slices/slices_page.h"
#include "ui/views/angiogram_view.h"

namespace angiopose::app {

using ui::Command;
using ui::MovableView;

ViewPlacementController::ViewPlacementController(ui::MainWindow& window, QObject* parent)
    : QObject(parent), window_(window)
{
    connectSingleView(Command::ImageOnly, MovableView::Image);
    connectSingleView(Command::CornerOnly, MovableView::Corner);
    connectWindow(Command::ImageWindow, MovableView::Image);
    connectWindow(Command::CornerWindow, MovableView::Corner);
    connectWindow(Command::SlicesWindow, MovableView::Slices);
    connectSlices();
    connectCollapsing(Command::FoldLeft, ui::ColumnSide::Left);
    connectCollapsing(Command::FoldRight, ui::ColumnSide::Right);
    connect(window.actions()[Command::FullScreen], &QAction::toggled, this,
            [this](bool on) { window_.setWindowState(window_.windowState().setFlag(Qt::WindowFullScreen, on)); });
    ui::WindowActions& actions = window.actions();
    connect(&window.angiogramView(), &ui::AngiogramView::enlargeRequested, actions[Command::ImageOnly],
            &QAction::toggle);
    connect(&window.corner(), &ui::CornerViews::maximizeRequested, actions[Command::CornerOnly], &QAction::toggle);
    connect(&window.corner(), &ui::CornerViews::popOutRequested, actions[Command::CornerWindow], &QAction::toggle);
    connect(&window.slicesPage(), &ui::SlicesPage::popOutRequested, actions[Command::SlicesWindow], &QAction::toggle);
}

void ViewPlacementController::connectSingleView(Command command, MovableView view)
{
    QAction* alone = window_.actions()[command];
    connect(alone, &QAction::toggled, this, [this, view](bool on) { setSingleView(view, on); });
    connect(&window_.frameOf(view), &ui::ViewFrame::poppedOutChanged, alone, [alone] { alone->setChecked(false); });
    connect(&window_, &ui::MainWindow::welcomeShown, alone, [alone] { alone->setChecked(false); });
}

void ViewPlacementController::connectWindow(Command command, MovableView view)
{
    QAction* out = window_.actions()[command];
    ui::ViewFrame& frame = window_.frameOf(view);
    out->setChecked(frame.isPoppedOut());
    connect(out, &QAction::toggled, &frame, &ui::ViewFrame::setPoppedOut);
    connect(&frame, &ui::ViewFrame::poppedOutChanged, out, &QAction::setChecked);
}

/// Connects the slice commands: slices in a separate window also count as enlarged.
void ViewPlacementController::connectSlices()
{
    QAction* large = window_.actions()[Command::SlicesLarge];
    QAction* out = window_.actions()[Command::SlicesWindow];
    connect(out, &QAction::toggled, large, &QAction::setChecked);
    const auto follow = [large, out] { out->setEnabled(large->isEnabled()); };
    connect(large, &QAction::changed, out, follow);
    follow();
}

void ViewPlacementController::connectCollapsing(Command command, ui::ColumnSide side)
{
    QAction* fold = window_.actions()[command];
    ui::FoldingColumn& column = window_.column(side);
    connect(fold, &QAction::toggled, &column, &ui::FoldingColumn::setFolded);
    connect(&column, &ui::FoldingColumn::foldedChanged, fold, &QAction::setChecked);
}

/// Shows one view alone; if the view is in a separate window, shows that window full screen instead.
void ViewPlacementController::setSingleView(MovableView view, bool on)
{
    ui::ViewFrame& frame = window_.frameOf(view);
    if (frame.isPoppedOut()) {
        frame.setFullScreen(on);
        return;
    }
    if (on) {
        const Command other = view == MovableView::Image ? Command::CornerOnly : Command::ImageOnly;
        if (!window_.frameOf(view == MovableView::Image ? MovableView::Corner : MovableView::Image).isPoppedOut()) {
            window_.actions()[other]->setChecked(false);
        }
    }
    window_.maximizeView(on ? std::optional(view) : std::nullopt);
}

}   // namespace angiopose::app
