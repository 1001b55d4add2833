#include "ui/panels/recent_list.h"

#include "ui/controls/glyph_button.h"
#include "ui/controls/section.h"
#include "ui/theme/active_theme.h"
#include "ui/words/retranslation.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QIcon>
#include <QLineEdit>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr int tileSize = 44;
constexpr int listWidth = 480;
constexpr int rowHeight = 54;
constexpr std::size_t maxVisibleRows = 5;   // scrolling or searching shows further rows

/// Returns the central square of the thumbnail, sharp at any scale, or a tile with the program icon.
QIcon thumbnailOf(const QImage& picture, double ratio)
{
    const int side = static_cast<int>(std::lround(tileSize * ratio));
    QPixmap tile(side, side);
    tile.fill(toQColor(activePalette().field));
    QPainter painter(&tile);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (picture.isNull()) {
        QIcon(QStringLiteral(":/icons/angiopose.svg"))
            .paint(&painter, tile.rect().adjusted(side / 5, side / 5, -side / 5, -side / 5));
    } else {
        const int sidePx = std::min(picture.width(), picture.height());
        painter.drawImage(tile.rect(), picture,
                          QRect((picture.width() - sidePx) / 2, (picture.height() - sidePx) / 2, sidePx, sidePx));
    }
    painter.end();
    tile.setDevicePixelRatio(ratio);
    return tile;
}

/// Button that elides a case name that is wider than the list.
class RecentButton : public QPushButton {
public:
    explicit RecentButton(const QString& name) : QPushButton(name), name_(name) { setAccessibleName(name); }

protected:
    void resizeEvent(QResizeEvent* event) override
    {
        QPushButton::resizeEvent(event);
        ensurePolished();
        setText(fontMetrics().elidedText(name_, Qt::ElideMiddle, width() - tileSize - aroundName));
    }

private:
    static constexpr int aroundName = 26;

    QString name_;
};

}   // namespace

RecentList::RecentList(QWidget* parent)
    : QWidget(parent),
      search_(new QLineEdit),
      rows_(new QWidget),
      rowLayout_(new QVBoxLayout(rows_)),
      area_(new QScrollArea),
      emptyLabel_(withText(roleLabel("hint"), [] { return tr("No recent case matches this name or folder."); })),
      showThumbnails_(withText(new QCheckBox, [] { return tr("Thumbnails"); })),
      clear_(withText(new QPushButton, [] { return tr("Clear list"); }))
{
    setMaximumWidth(listWidth);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    keepTranslated(search_, [search = search_] {
        search->setPlaceholderText(tr("Search recent cases"));
        search->setAccessibleName(tr("Search recent cases"));
    });
    search_->setClearButtonEnabled(true);
    rowLayout_->setContentsMargins(0, 0, 0, 0);
    rowLayout_->setSpacing(2);
    area_->setWidget(rows_);
    area_->setWidgetResizable(true);
    area_->setFrameShape(QFrame::NoFrame);
    area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    rows_->setAutoFillBackground(false);
    area_->viewport()->setAutoFillBackground(false);
    withToolTip(showThumbnails_,
                [] { return tr("Stores a thumbnail of each recent case in the program's cache folder."); });
    clear_->setProperty("role", "link");
    withToolTip(clear_, [] {
        return tr("Removes these cases and their thumbnails from the list. Pinned cases and all files are kept.");
    });
    auto* foot = new QHBoxLayout;
    foot->addWidget(showThumbnails_);
    foot->addStretch(1);
    foot->addWidget(clear_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(search_);
    layout->addWidget(area_);
    emptyLabel_->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    layout->addWidget(emptyLabel_);
    layout->addLayout(foot);
    connect(search_, &QLineEdit::textChanged, this, &RecentList::showMatches);
    connect(showThumbnails_, &QCheckBox::clicked, this, &RecentList::thumbnailsToggled);
    connect(clear_, &QPushButton::clicked, this, &RecentList::clearRequested);
    hide();
}

QString RecentList::labelOf(const QString& path, RecentCase::State state)
{
    const QString name = path.section(u'/', -1);
    switch (state) {
        case RecentCase::State::Missing:
            return tr("%1 (missing)").arg(name);
        case RecentCase::State::InputsMissing:
            return tr("%1 (inputs missing)").arg(name);
        case RecentCase::State::Present:
            break;
    }
    return name;
}

/// Creates the row of a case: a button with thumbnail and name, a pin toggle and a remove button.
QWidget* RecentList::makeRow(const RecentCase& recent)
{
    const bool isGone = recent.state == RecentCase::State::Missing;
    const QString name = labelOf(recent.path, recent.state);
    auto* row = new QWidget;
    row->setFixedHeight(rowHeight);
    auto* open = new RecentButton(name);
    open->setProperty("role", "recent");
    open->setIconSize({tileSize, tileSize});
    open->setIcon(thumbnailOf(isGone ? QImage() : recent.picture, devicePixelRatioF()));
    open->setToolTip(recent.path);
    open->setEnabled(!isGone);
    open->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* pin = new GlyphButton(GlyphButton::Glyph::Pin);
    pin->setCheckable(true);
    pin->setChecked(recent.isPinned);
    pin->setAutoRaise(true);
    pin->setToolTip(recent.isPinned ? tr("Pinned: stays at the top of the list") : tr("Pin to the top of the list"));
    pin->setAccessibleName(tr("Pin %1").arg(name));
    auto* remove = new GlyphButton(GlyphButton::Glyph::Remove);
    remove->setAutoRaise(true);
    remove->setToolTip(tr("Remove from the list; the file is kept"));
    remove->setAccessibleName(tr("Remove %1 from the list").arg(name));
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(open, 1);
    layout->addWidget(pin);
    layout->addWidget(remove);
    const QString path = recent.path;
    connect(open, &QPushButton::clicked, this, [this, path] { emit openRequested(path); });
    connect(pin, &QToolButton::clicked, this, [this, path](bool isPinned) { emit pinToggled(path, isPinned); });
    connect(remove, &QToolButton::clicked, this, [this, path] { emit removeRequested(path); });
    return row;
}

void RecentList::clearRows()
{
    while (QLayoutItem* item = rowLayout_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

void RecentList::showCases(const std::vector<RecentCase>& cases, bool hasThumbnails)
{
    cases_ = cases;
    clearRows();
    for (const RecentCase& recent : cases_) {
        rowLayout_->addWidget(makeRow(recent));
    }
    rowLayout_->addStretch(1);
    showThumbnails_->setChecked(hasThumbnails);
    search_->setVisible(cases_.size() > maxVisibleRows);
    if (cases_.size() <= maxVisibleRows) {
        search_->clear();
    }
    setVisible(!cases_.empty());
    showMatches();
}

/// Shows the cases whose path contains all search words.
void RecentList::showMatches()
{
    const QStringList words = search_->text().split(u' ', Qt::SkipEmptyParts);
    std::size_t matchCount = 0;
    for (std::size_t i = 0; i < cases_.size(); ++i) {
        const QString& path = cases_[i].path;
        const bool matches = std::ranges::all_of(
            words, [&path](const QString& word) { return path.contains(word, Qt::CaseInsensitive); });
        rowLayout_->itemAt(static_cast<int>(i))->widget()->setVisible(matches);
        matchCount += matches ? 1 : 0;
    }
    emptyLabel_->setVisible(matchCount == 0 && !cases_.empty());
    area_->setVisible(matchCount > 0);
    // Fixes the height, so that the search field stays in place regardless of the number of matches.
    const std::size_t visibleRows =
        std::clamp<std::size_t>(search_->isHidden() ? matchCount : cases_.size(), 1, maxVisibleRows);
    const int keptHeight = static_cast<int>(visibleRows) * (rowHeight + rowLayout_->spacing());
    area_->setFixedHeight(keptHeight);
    emptyLabel_->setFixedHeight(keptHeight);
}

}   // namespace angiopose::ui
