#include "ui/controls/section.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHash>
#include <QPainter>
#include <QStyle>

namespace angiopose::ui {
namespace {

/// Label that caches its height per width: layouts request the height whenever a column folds or unfolds, and every
/// request would lay out the text again.
class WrappedLabel : public QLabel {
public:
    using QLabel::QLabel;

    int heightForWidth(int width) const override;

protected:
    void changeEvent(QEvent* event) override;

private:
    mutable QString cacheKey_;   ///< text and role to which the cached heights belong
    mutable QHash<int, int> heightOfWidth_;
};

int WrappedLabel::heightForWidth(int width) const
{
    if (!wordWrap()) {
        return QLabel::heightForWidth(width);
    }
    const QString newKey = property("role").toString() + text();   // font and padding depend on the role
    if (newKey != cacheKey_) {
        cacheKey_ = newKey;
        heightOfWidth_.clear();
    }
    const auto cached = heightOfWidth_.constFind(width);
    return cached != heightOfWidth_.cend() ? *cached : *heightOfWidth_.insert(width, QLabel::heightForWidth(width));
}

/// Clears the cache when the font or style changes.
void WrappedLabel::changeEvent(QEvent* event)
{
    heightOfWidth_.clear();
    QLabel::changeEvent(event);
}

}   // namespace

ElidedLabel::ElidedLabel(const char* role, QWidget* parent) : QLabel(parent)
{
    setProperty("role", role);
    setTextFormat(Qt::PlainText);
}

void ElidedLabel::showText(const QString& text)
{
    setText(text);
    setToolTip(text);
}

QSize ElidedLabel::minimumSizeHint() const
{
    return {1, QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, width());
    style()->drawItemText(&painter, rect(), static_cast<int>(alignment()) | Qt::TextSingleLine, palette(), isEnabled(),
                          shown, foregroundRole());
}

Section::Section(const char* name, const LocalizedText& title, Folding folding, QWidget* parent)
    : QWidget(parent),
      title_(withText(roleLabel("heading"), title)),
      hint_(new ElidedLabel("hint")),
      content_(new QWidget)
{
    auto* header = new QHBoxLayout;
    header->setSpacing(6);
    if (folding == Folding::Foldable) {
        fold_ = new QToolButton;
        fold_->setProperty("role", "fold");
        fold_->setArrowType(Qt::DownArrow);
        fold_->setFocusPolicy(Qt::TabFocus);   // avoids a focus rectangle after a click
        withAccessibleName(fold_, [title] { return tr("Collapse or expand %1").arg(title()); });
        connect(fold_, &QToolButton::clicked, this, [this] { setFolded(!isFolded()); });
        title_->installEventFilter(this);
        hint_->installEventFilter(this);
        header->addWidget(fold_);
    }
    header->addWidget(title_);
    hint_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    header->addWidget(hint_, 1);

    setObjectName(QLatin1String(name));
    contentLayout_ = new QVBoxLayout(content_);
    contentLayout_->setContentsMargins(0, 0, 0, 0);
    contentLayout_->setSpacing(6);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(14, 10, 14, 6);
    layout->setSpacing(8);
    layout->addLayout(header);
    layout->addWidget(content_);
}

void Section::setHint(const QString& hint)
{
    hint_->showText(hint);
}

void Section::setFolded(bool folded)
{
    if (folded == isFolded() && fold_ && fold_->arrowType() == (folded ? Qt::RightArrow : Qt::DownArrow)) {
        return;
    }
    content_->setVisible(!folded);
    if (fold_) {
        fold_->setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
    }
    emit foldedChanged(folded);
}

bool Section::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::MouseButtonRelease && (watched == title_ || watched == hint_)) {
        setFolded(!isFolded());
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

QLabel* roleLabel(const char* role, const QString& text, QWidget* parent)
{
    auto* label = new WrappedLabel(text, parent);
    label->setProperty("role", role);
    return label;
}

void setRole(QWidget* widget, const char* role)
{
    if (widget->property("role").toByteArray() == role) {
        return;
    }
    widget->setProperty("role", role);
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
}

}   // namespace angiopose::ui
