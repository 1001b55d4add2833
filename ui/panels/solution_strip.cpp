#include "ui/panels/solution_strip.h"

#include "ui/actions/key_hint.h"
#include "ui/words/retranslation.h"

#include <QListWidget>
#include <QScopedValueRollback>

namespace angiopose::ui {
namespace {

constexpr int solutionThumbnailSize = 84;

QPixmap pixmapOf(const core::ColorImage& picture, double ratio)
{
    const uchar* bytes = picture.rgb.data();
    const QImage image(bytes, picture.width, picture.height, qsizetype{3} * picture.width, QImage::Format_RGB888);
    QPixmap pixmap = QPixmap::fromImage(image.copy());   // deep copy of the temporary buffer
    pixmap.setDevicePixelRatio(ratio);
    return pixmap;
}

}   // namespace

SolutionStrip::SolutionStrip(QWidget* parent)
    : Section(
          "solutions", [] { return tr("Solutions"); }, Folding::Foldable, parent),
      list_(new QListWidget)
{
    keepTranslated(this, [this] {
        setHint(tr("%1: next · %2: accept").arg(keyOf(Command::NextSolution), keyOf(Command::AcceptSolution)));
    });
    withAccessibleName(list_, [] { return tr("Solutions of this registration"); });
    list_->setViewMode(QListView::IconMode);
    list_->setMovement(QListView::Static);
    list_->setFlow(QListView::LeftToRight);
    list_->setWrapping(false);
    list_->setIconSize({solutionThumbnailSize, solutionThumbnailSize});
    list_->setSpacing(2);
    list_->setUniformItemSizes(true);
    list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setSelectionMode(QAbstractItemView::SingleSelection);
    list_->setFixedHeight(solutionThumbnailSize + 2 * list_->fontMetrics().height() + 20);
    contentLayout()->addWidget(list_);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!isUpdating_ && row >= 0) {
            emit solutionPicked(row);
        }
    });
    connect(list_, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { emit acceptRequested(list_->row(item)); });
    hide();
}

int SolutionStrip::thumbnailWidthPx() const
{
    return static_cast<int>(solutionThumbnailSize * devicePixelRatioF());
}

void SolutionStrip::showSolutions(const std::vector<SolutionRow>& solutions)
{
    const QScopedValueRollback quiet(isUpdating_, true);
    list_->clear();
    QPixmap empty(thumbnailWidthPx(), thumbnailWidthPx());
    empty.fill(Qt::black);
    empty.setDevicePixelRatio(devicePixelRatioF());
    for (const SolutionRow& solution : solutions) {
        auto* item = new QListWidgetItem(QIcon(empty), solution.label, list_);
        item->setToolTip(solution.toolTip);
        item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
    }
    setVisible(solutions.size() > 1);
}

void SolutionStrip::showThumbnail(int index, const core::ColorImage& picture)
{
    if (QListWidgetItem* item = list_->item(index)) {
        item->setIcon(QIcon(pixmapOf(picture, devicePixelRatioF())));
    }
}

void SolutionStrip::showCurrent(int index)
{
    const QScopedValueRollback quiet(isUpdating_, true);
    list_->setCurrentRow(index);
}

}   // namespace angiopose::ui
