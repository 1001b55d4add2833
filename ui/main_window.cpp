#include "ui/main_window.h"

#include "ui/controls/number_field.h"
#include "ui/controls/screen_fit.h"
#include "ui/places/folding_column.h"
#include "ui/places/side_by_side.h"
#include "ui/places/view_frame.h"
#include "ui/slices/corner_views.h"
#include "ui/slices/slices_page.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

#include <QApplication>
#include <QListView>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int rightMinimumWidth = 270;

QWidget* asColumn(QWidget* content)
{
    content->setProperty("role", "column");
    content->setAttribute(Qt::WA_StyledBackground);
    return content;
}

}   // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      actions_(new WindowActions(this)),
      header_(new HeaderBar),
      steps_(new StepBar),
      patient_(new PatientBar),
      branches_(new BranchPanel),
      treeView_(new TreeView),
      slices_(new SliceModel(this)),
      corner_(new CornerViews(treeView_, *slices_)),
      slicesPage_(new SlicesPage(*slices_)),
      tracing_(new TracingPanel),
      angiogramView_(new AngiogramView),
      sideBySide_(new SideBySide(*angiogramView_)),
      views_(new ViewStrip),
      welcome_(new WelcomePage),
      center_(new QStackedWidget),
      imageFrame_(new ViewFrame(*makeImagePlace(), [] { return tr("AngioPose: angiogram"); })),
      cornerFrame_(new ViewFrame(*corner_, [] { return tr("AngioPose: 3-D and slices"); })),
      slicesFrame_(new ViewFrame(*slicesPage_, [] { return tr("AngioPose: slices"); })),
      angiogramPanel_(new AngiogramPanel),
      geometry_(new GeometryPanel),
      pose_(new PosePanel),
      landmarks_(new LandmarkPanel),
      measure_(new MeasurePanel),
      marks_(new MarkPanel),
      profile_(new ProfilePanel),
      registration_(new RegistrationPanel),
      result_(new ResultPanel),
      snapshots_(new SnapshotPanel),
      trialBar_(new TrialBar),
      faultBar_(new FaultBar),
      rightPanels_(new QScrollArea),
      strip_(new BottomStrip),
      columns_(new QSplitter(Qt::Horizontal)),
      leftSplitter_(new QSplitter(Qt::Vertical)),
      leftColumn_(
          new FoldingColumn(ColumnSide::Left, *makeLeftColumn(), [] { return tr("Branches, 3-D and slices"); })),
      rightColumn_(
          new FoldingColumn(ColumnSide::Right, *makeRightColumn(), [] { return tr("Pose, registration, result"); }))
{
    setAcceptDrops(true);
    actions_->fillMenus(header_->menuBar());
    layOut();
    connectSlices();
    connectFrames();
    connectColumns();
    const auto showWith = [this](Command mode, QWidget* panel) {
        connect(actions()[mode], &QAction::toggled, this, [this, panel](bool on) {
            if (on) {   // deferred until the list of the panel has expanded
                QTimer::singleShot(0, this, [this, panel] { showInRightColumn(panel); });
            }
        });
    };
    showWith(Command::Landmarks, landmarks_);
    for (const Command mode : {Command::MeasureLength, Command::MeasureAngle, Command::MeasureArea}) {
        showWith(mode, measure_);
    }
    for (const Command mode :
         {Command::TargetPoint, Command::OstiumRing, Command::TargetInImage, Command::DrawArrow, Command::WriteText}) {
        showWith(mode, marks_);
    }
    connect(geometry_, &Section::foldedChanged, this, [this](bool folded) {
        if (!folded) {   // scrolls to the fields of the expanded section
            QTimer::singleShot(0, this, [this] { rightPanels_->ensureWidgetVisible(geometry_); });
        }
    });
    angiogramView_->setFocus();
    qApp->installEventFilter(this);
    new WheelGuard(this);
}

/// Lays out the header and the steps at the top, three columns, and the strip at the bottom.
void MainWindow::layOut()
{
    columns_->setProperty("role", "columns");
    columns_->addWidget(leftColumn_);
    columns_->addWidget(makeCenter());
    columns_->addWidget(rightColumn_);
    columns_->setStretchFactor(1, 1);
    columns_->setChildrenCollapsible(false);
    columns_->setHandleWidth(columnBorderWidth);
    leftColumn_->placeButton(*columns_->handle(1));
    rightColumn_->placeButton(*columns_->handle(2));

    auto* central = new QWidget;
    auto* layout = new QVBoxLayout(central);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(header_);
    layout->addWidget(steps_);
    layout->addWidget(patient_);
    layout->addWidget(trialBar_);
    layout->addWidget(faultBar_);
    layout->addWidget(columns_, 1);
    layout->addWidget(strip_);
    setCentralWidget(central);
    setMinimumSize(900, 560);
    resizeWithinScreen(*this, {1440, 900});
    setColumns({});
}

QWidget* MainWindow::makeLeftColumn()
{
    cornerFrame_->setMinimumHeight(120);
    leftSplitter_->addWidget(asColumn(branches_));
    leftSplitter_->addWidget(asColumn(cornerFrame_));
    leftSplitter_->setStretchFactor(0, 3);
    leftSplitter_->setStretchFactor(1, 2);
    leftSplitter_->setHandleWidth(1);
    leftSplitter_->setChildrenCollapsible(false);
    leftSplitter_->setMinimumWidth(230);
    return leftSplitter_;
}

/// Creates the frame around the angiogram, its view strip and the side-by-side views, which pop out together.
QWidget* MainWindow::makeImagePlace()
{
    auto* place = new QWidget;
    auto* layout = new QVBoxLayout(place);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(views_);
    layout->addWidget(sideBySide_, 1);
    place->setFocusProxy(angiogramView_);
    return place;
}

QWidget* MainWindow::makeCenter()
{
    imageFrame_->setProperty("role", "canvas");
    imageFrame_->setAttribute(Qt::WA_StyledBackground);
    center_->addWidget(welcome_);
    center_->addWidget(imageFrame_);
    slicesPage_->setSidePanel(tracing_);
    center_->addWidget(slicesFrame_);
    center_->setMinimumWidth(320);
    return center_;
}

QWidget* MainWindow::makeRightColumn()
{
    auto* content = asColumn(new QWidget);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 8);
    layout->setSpacing(2);
    layout->addWidget(pose_);
    layout->addWidget(registration_);
    layout->addWidget(result_);
    auto* verdict = static_cast<QVBoxLayout*>(result_->layout());   // places the snapshots above the plots
    verdict->insertWidget(verdict->indexOf(&result_->solutions()) + 1, snapshots_);
    layout->addWidget(landmarks_);
    layout->addWidget(measure_);
    layout->addWidget(marks_);
    layout->addWidget(profile_);
    layout->addWidget(angiogramPanel_);
    layout->addWidget(geometry_);
    layout->addStretch(1);
    rightPanels_->setProperty("role", "column");
    rightPanels_->setWidget(content);
    rightPanels_->setWidgetResizable(true);
    rightPanels_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    rightPanels_->setMinimumWidth(rightMinimumWidth);
    return rightPanels_;
}

/// Widens the column if an unfolded section requires more width, since the column has no horizontal scroll bar.
void MainWindow::widenRightColumn()
{
    const int scrollBar = rightPanels_->verticalScrollBar()->sizeHint().width();
    rightPanels_->setMinimumWidth(
        std::max(rightMinimumWidth, rightPanels_->widget()->minimumSizeHint().width() + scrollBar));
}

void MainWindow::connectColumns()
{
    for (const ColumnSide side : {ColumnSide::Left, ColumnSide::Right}) {
        connect(&column(side), &FoldingColumn::foldedChanged, this, [this, side] { saveWidthOf(side); });
    }
    for (const Command command : {Command::FindBranch, Command::RenameBranch, Command::NextCornerView,
                                  Command::ResetTreeView, Command::ScanIn3d, Command::NextScanRendering}) {
        connect(actions()[command], &QAction::triggered, leftColumn_, [this] { leftColumn_->setFolded(false); });
    }
}

/// Sets a folded column to the width of its rail and an unfolded one to its previous width; the center column absorbs
/// the difference.
void MainWindow::saveWidthOf(ColumnSide side)
{
    QList<int> widths = columns_->sizes();
    const FoldingColumn& folding = column(side);
    const qsizetype place = side == ColumnSide::Left ? 0 : 2;
    const int width = folding.isFolded() ? folding.minimumWidth() : folding.openWidth();
    widths[1] = std::max(1, widths[1] + widths[place] - width);
    widths[place] = width;
    if (!maximizedView_) {
        columns_->setSizes(widths);
    }
}

void MainWindow::showInRightColumn(QWidget* panel)
{
    if (rightColumn_->isFolded()) {
        rightColumn_->setFolded(false);
        QTimer::singleShot(0, this, [this, panel] { rightPanels_->ensureWidgetVisible(panel); });   // after the layout
    } else {
        rightPanels_->ensureWidgetVisible(panel);
    }
}

void MainWindow::showImagePage()
{
    center_->setCurrentWidget(slicesEnlarged_ && !slicesFrame_->isPoppedOut() ? slicesFrame_ : imageFrame_);
}

void MainWindow::setSlicesEnlarged(bool large)
{
    slicesEnlarged_ = large;
    if (!large) {
        slicesFrame_->setPoppedOut(false);
    }
    if (center_->currentWidget() != welcome_) {
        showImagePage();
    }
    QWidget* shown = large ? static_cast<QWidget*>(&slicesPage_->view(core::BodyPlane::Axial)) : angiogramView_;
    shown->setFocus(Qt::OtherFocusReason);
}

void MainWindow::connectSlices()
{
    std::vector<SliceView*> views{&corner_->slice()};
    for (const core::BodyPlane plane : core::bodyPlanes) {
        views.push_back(&slicesPage_->view(plane));
    }
    for (SliceView* view : views) {
        connect(view, &SliceView::pointPicked, this, &MainWindow::pointPicked);
    }
    connect(treeView_, &TreeView::pointPicked, this, &MainWindow::pointPicked);
}

void MainWindow::connectFrames()
{
    for (ViewFrame* frame : {imageFrame_, cornerFrame_, slicesFrame_}) {
        connect(frame, &ViewFrame::poppedOutChanged, this, [this] {
            placeViews();
            if (center_->currentWidget() != welcome_) {
                showImagePage();
            }
        });
    }
}

ViewFrame& MainWindow::frameOf(MovableView view)
{
    return view == MovableView::Image ? *imageFrame_ : view == MovableView::Corner ? *cornerFrame_ : *slicesFrame_;
}

void MainWindow::maximizeView(std::optional<MovableView> view)
{
    if (!maximizedView_ && view) {
        layoutBefore_ = columns();
        savedColumns_ = columns_->saveState();
        savedLeft_ = leftSplitter_->saveState();
    }
    const bool isRestored = maximizedView_ && !view;
    maximizedView_ = view;
    if (isRestored) {   // restores the sizes before showing the columns, which avoids a layout at a temporary width
        columns_->restoreState(savedColumns_);
        leftSplitter_->restoreState(savedLeft_);
    }
    placeViews();
}

void MainWindow::placeViews()
{
    const bool cornerAlone = maximizedView_ == MovableView::Corner;
    branches_->setVisible(!maximizedView_);
    cornerFrame_->setVisible(!cornerFrame_->isPoppedOut());
    leftColumn_->setHeldOpen(cornerAlone);
    leftColumn_->setVisible(!maximizedView_ || cornerAlone);
    center_->setVisible(!cornerAlone);
    rightColumn_->setVisible(!maximizedView_);
}

void MainWindow::showWelcomePage()
{
    center_->setCurrentWidget(welcome_);
    emit welcomeShown();
}

void MainWindow::focusStep(Step step)
{
    switch (step) {
        case Step::Vessels:
            leftColumn_->setFolded(false);
            branches_->list()->setFocus(Qt::OtherFocusReason);
            break;
        case Step::Angiogram:
            angiogramPanel_->setFolded(false);
            showInRightColumn(angiogramPanel_);
            angiogramView_->setFocus(Qt::OtherFocusReason);
            break;
        case Step::Geometry:
            geometry_->focusFirstMissing();
            showInRightColumn(geometry_);
            break;
        case Step::InitialPose:
            showInRightColumn(pose_);
            pose_->findChild<NumberField*>()->setFocus(Qt::OtherFocusReason);
            break;
        case Step::Register:
            showInRightColumn(registration_);
            registration_->registerButton()->setFocus(Qt::OtherFocusReason);
            break;
        case Step::Review:
            showInRightColumn(result_);
            rightPanels_->verticalScrollBar()->setValue(result_->y());   // the verdict is at the top of the result
            break;
        case Step::Export:
            actions()[Command::ExportOverlay]->trigger();
            return;
    }
    steps_->showCurrent(step);
}

void MainWindow::closeNow()
{
    closeAllowed_ = true;
    // Queued because Qt ignores close() inside a close event.
    QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection);
}

}   // namespace angiopose::ui
