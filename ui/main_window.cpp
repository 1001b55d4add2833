#include "ui/main_window.h"

#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

#include <QApplication>
#include <QDataStream>
#include <QIODevice>
#include <QListView>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace ui {
namespace {

constexpr int leftWidth = 300;
constexpr int rightWidth = 320;

QWidget* column(QWidget* content)
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
      branches_(new BranchPanel),
      treeView_(new TreeView),
      angiogramView_(new AngiogramView),
      welcome_(new WelcomePage),
      centre_(new QStackedWidget),
      imageFrame_(new QWidget),
      geometry_(new GeometryPanel),
      pose_(new PosePanel),
      landmarks_(new LandmarkPanel),
      registration_(new RegistrationPanel),
      result_(new ResultPanel),
      rightColumn_(new QScrollArea),
      strip_(new BottomStrip),
      columns_(new QSplitter(Qt::Horizontal)),
      leftSplitter_(new QSplitter(Qt::Vertical))
{
    setAcceptDrops(true);
    actions_->fillMenus(header_->menuBar());
    columns_->addWidget(makeLeftColumn());
    columns_->addWidget(makeCentre());
    columns_->addWidget(makeRightColumn());
    columns_->setStretchFactor(1, 1);
    columns_->setSizes({leftWidth, 10000, rightWidth});
    columns_->setCollapsible(1, false);
    columns_->setHandleWidth(1);

    auto* central = new QWidget;
    auto* layout = new QVBoxLayout(central);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(header_);
    layout->addWidget(steps_);
    layout->addWidget(columns_, 1);
    layout->addWidget(strip_);
    setCentralWidget(central);
    setMinimumSize(900, 560);
    resize(1440, 900);
    angiogramView_->setFocus();
    qApp->installEventFilter(this);
}

QWidget* MainWindow::makeLeftColumn()
{
    auto* tree = new QWidget;
    auto* layout = new QVBoxLayout(tree);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(treeView_);
    tree->setMinimumHeight(120);
    leftSplitter_->addWidget(column(branches_));
    leftSplitter_->addWidget(column(tree));
    leftSplitter_->setStretchFactor(0, 3);
    leftSplitter_->setStretchFactor(1, 2);
    leftSplitter_->setSizes({420, 300});
    leftSplitter_->setHandleWidth(1);
    leftSplitter_->setChildrenCollapsible(false);
    leftSplitter_->setMinimumWidth(230);
    return leftSplitter_;
}

QWidget* MainWindow::makeCentre()
{
    imageFrame_->setProperty("role", "canvas");
    imageFrame_->setAttribute(Qt::WA_StyledBackground);
    auto* layout = new QVBoxLayout(imageFrame_);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(angiogramView_);
    centre_->addWidget(welcome_);
    centre_->addWidget(imageFrame_);
    centre_->setMinimumWidth(320);
    return centre_;
}

QWidget* MainWindow::makeRightColumn()
{
    auto* content = column(new QWidget);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 8);
    layout->setSpacing(2);
    layout->addWidget(pose_);
    layout->addWidget(registration_);
    layout->addWidget(result_);
    layout->addWidget(landmarks_);
    layout->addWidget(geometry_);
    layout->addStretch(1);
    rightColumn_->setProperty("role", "column");
    rightColumn_->setWidget(content);
    rightColumn_->setWidgetResizable(true);
    rightColumn_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    rightColumn_->setMinimumWidth(270);
    return rightColumn_;
}

void MainWindow::showImagePage()
{
    centre_->setCurrentWidget(imageFrame_);
}

void MainWindow::showWelcomePage()
{
    centre_->setCurrentWidget(welcome_);
}

void MainWindow::focusStep(Step step)
{
    switch (step) {
        case Step::Vessels:
            branches_->list()->setFocus(Qt::OtherFocusReason);
            break;
        case Step::Angiogram:
            angiogramView_->setFocus(Qt::OtherFocusReason);
            break;
        case Step::Geometry:
            geometry_->focusFirstMissing();
            rightColumn_->ensureWidgetVisible(geometry_);
            break;
        case Step::StartPose:
            rightColumn_->ensureWidgetVisible(pose_);
            pose_->findChild<NumberField*>()->setFocus(Qt::OtherFocusReason);
            break;
        case Step::Register:
            rightColumn_->ensureWidgetVisible(registration_);
            registration_->registerButton()->setFocus(Qt::OtherFocusReason);
            break;
        case Step::Review:
            rightColumn_->ensureWidgetVisible(result_);
            break;
        case Step::Export:
            actions()[Command::ExportOverlay]->trigger();
            return;
    }
    steps_->showCurrent(step);
}

QByteArray MainWindow::layoutState() const
{
    QByteArray state;
    QDataStream stream(&state, QIODevice::WriteOnly);
    stream << saveGeometry() << columns_->saveState() << leftSplitter_->saveState();
    return state;
}

void MainWindow::restoreLayout(const QByteArray& state)
{
    QDataStream stream(state);
    QByteArray windowGeometry;
    QByteArray columnState;
    QByteArray leftState;
    stream >> windowGeometry >> columnState >> leftState;
    restoreGeometry(windowGeometry);
    columns_->restoreState(columnState);
    leftSplitter_->restoreState(leftState);
}

void MainWindow::closeNow()
{
    closeAllowed_ = true;
    // Queued: this may be the answer to a close event, in which closing again would be ignored.
    QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection);
}

}   // namespace ui
