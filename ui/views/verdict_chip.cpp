#include "ui/views/verdict_chip.h"

#include "ui/theme/active_theme.h"

#include <QEvent>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int edgePx = 6;   // distance from the image border, px
constexpr int padPx = 10;

}   // namespace

VerdictChip::VerdictChip(QWidget& image) : QLabel(&image)
{
    setObjectName(QStringLiteral("verdict"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAlignment(Qt::AlignCenter);
    setTextFormat(Qt::PlainText);
    hide();
    image.installEventFilter(this);
}

void VerdictChip::showVerdict(VerdictTone tone, const QString& fullText)
{
    if (tone == tone_ && fullText == fullText_) {
        return;
    }
    tone_ = tone;
    fullText_ = fullText;
    const Palette& colors = ui::palette(ThemeMode::Dark);   // images have a dark background in every theme
    const Color& color = tone == VerdictTone::Good       ? colors.fine
                         : tone == VerdictTone::Doubtful ? colors.attention
                                                         : colors.error;
    setStyleSheet(QStringLiteral("QLabel { background: %1; color: %2; border: 1px solid %2; border-radius: 4px; "
                                 "font-weight: 600; padding: 0px; }")
                      .arg(QString::fromStdString(colors.canvas.hex()), QString::fromStdString(color.hex())));
    setAccessibleName(fullText);
    place();
    setVisible(!fullText.isEmpty());
}

void VerdictChip::place()
{
    const int maxWidth = std::max(1, parentWidget()->width() - 2 * edgePx);
    ensurePolished();
    const int width = std::min(maxWidth, fontMetrics().horizontalAdvance(fullText_) + 2 * padPx);
    setText(fontMetrics().elidedText(fullText_, Qt::ElideRight, std::max(1, width - padPx)));
    setGeometry((parentWidget()->width() - width) / 2, edgePx, width, fontMetrics().height() + padPx);
}

bool VerdictChip::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize) {
        place();
    }
    return QLabel::eventFilter(watched, event);
}

void VerdictChip::changeEvent(QEvent* event)
{
    QLabel::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        place();
    }
}

}   // namespace angiopose::ui
