#include "ui/panels/landmark_panel.h"

#include "ui/actions/key_hint.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QAction>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>

#include <cmath>

namespace angiopose::ui {
namespace {

constexpr int maxVisibleLandmarks = 6;

}   // namespace

LandmarkPanel::LandmarkPanel(QWidget* parent)
    : Section(
          "landmarks", [] { return tr("Landmarks"); }, Folding::Foldable, parent),
      list_(new QListWidget),
      verdict_(roleLabel("hint")),
      modeButton_(withText(new QPushButton, [] { return withShortcut(tr("Pick pairs"), Command::Landmarks); })),
      place_(withText(new QPushButton, [] { return tr("Compute pose"); })),
      remove_(withText(new QPushButton, [] { return tr("Remove"); }))
{
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    withAccessibleName(list_, [] { return tr("Landmarks and their residuals"); });
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->installEventFilter(this);
    verdict_->setWordWrap(true);
    modeButton_->setCheckable(true);
    withToolTip(modeButton_, [] {
        return tooltipWithShortcut(
            tr("Click a point on the vessels in 3-D (or a slice), then the same point in the image."),
            Command::Landmarks);
    });
    withToolTip(place_, [] {
        return tr(
            "Computes the initial pose from the pairs, as does pressing Enter while picking. Undo restores the "
            "previous pose.");
    });
    withToolTip(remove_, [] { return tr("Removes the selected pairs (Delete)"); });
    remove_->setProperty("role", "quiet");
    connect(place_, &QPushButton::clicked, this, &LandmarkPanel::poseRequested);
    connect(remove_, &QPushButton::clicked, this, &LandmarkPanel::removeSelected);
    connect(list_, &QListWidget::itemSelectionChanged, this,
            [this] { remove_->setEnabled(!list_->selectedItems().isEmpty()); });
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(modeButton_);
    buttons->addWidget(place_);
    buttons->addWidget(remove_);
    contentLayout()->addWidget(list_);
    contentLayout()->addWidget(verdict_);
    contentLayout()->addLayout(buttons);
    setFolded(true);
    showLandmarks({});
    keepTranslated(this, [this] { showKeys(); });
}

void LandmarkPanel::bindMode(QAction& action)
{
    connect(modeButton_, &QPushButton::clicked, &action, [&action](bool on) { action.setChecked(on); });
    connect(&action, &QAction::toggled, this, [this](bool on) {
        modeButton_->setChecked(on);
        if (on) {
            setFolded(false);
        }
    });
}

void LandmarkPanel::showLandmarks(const LandmarkState& state)
{
    count_ = state.landmarks.size();
    list_->clear();
    for (std::size_t i = 0; i < state.landmarks.size(); ++i) {
        const QString name = QString::fromStdString(state.landmarks[i].name);
        const bool isKnown = i < state.errorPx.size() && std::isfinite(state.errorPx[i]);
        const QString error = isKnown ? tr("%1 px").arg(numberText(state.errorPx[i], 1)) : tr("not in view");
        list_->addItem(QStringLiteral("%1   %2   %3").arg(i + 1).arg(name, error));
    }
    const int rows = std::min(list_->count(), maxVisibleLandmarks);
    list_->setVisible(rows > 0);
    list_->setFixedHeight(rows > 0 ? rows * list_->sizeHintForRow(0) + 4 : 0);
    verdict_->setText(state.verdict);
    verdict_->setVisible(!state.verdict.isEmpty());
    place_->setEnabled(state.isEnough);
    remove_->setEnabled(false);
    showKeys();
}

void LandmarkPanel::showKeys()
{
    setHint(count_ == 0 ? tr("%1: click pairs, then compute").arg(keyOf(Command::Landmarks))
                        : tr("%1 pairs").arg(count_));
}

void LandmarkPanel::removeSelected()
{
    std::vector<int> indices;
    for (const QListWidgetItem* item : list_->selectedItems()) {
        indices.push_back(list_->row(item));
    }
    if (!indices.empty()) {
        emit removeRequested(indices);
    }
}

bool LandmarkPanel::eventFilter(QObject* watched, QEvent* event)
{
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (watched == list_ && isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
        event->accept();
        if (event->type() == QEvent::KeyPress) {
            removeSelected();
        }
        return true;
    }
    return Section::eventFilter(watched, event);
}

}   // namespace angiopose::ui
