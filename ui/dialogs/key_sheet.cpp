#include "ui/dialogs/key_sheet.h"

#include "ui/panels/section.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace ui {
namespace {

bool matches(const KeyLine& line, const QString& words)
{
    const QString whole = line.keys + QLatin1Char(' ') + line.effect;
    const QStringList parts = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    return std::ranges::all_of(parts,
                               [&whole](const QString& part) { return whole.contains(part, Qt::CaseInsensitive); });
}

QString tableOf(const std::vector<KeyLine>& lines)
{
    QString rows;
    QString heading;
    for (const KeyLine& line : lines) {
        if (line.heading != heading) {
            rows += QStringLiteral("<tr><td colspan='2'>%1<b>%2</b></td></tr>")
                        .arg(heading.isEmpty() ? QString() : QStringLiteral("<br/>"), line.heading.toHtmlEscaped());
            heading = line.heading;
        }
        rows += QStringLiteral("<tr><td style='padding-right:18px'><b>%1</b></td><td>%2</td></tr>")
                    .arg(line.keys.toHtmlEscaped(), line.effect.toHtmlEscaped());
    }
    return QStringLiteral("<table>%1</table>").arg(rows);
}

}   // namespace

KeySheet::KeySheet(std::vector<KeyLine> lines, QWidget* parent)
    : QDialog(parent), lines_(std::move(lines)), search_(new QLineEdit), text_(roleLabel("body"))
{
    setObjectName(QStringLiteral("keySheet"));
    setWindowTitle(tr("Keys"));
    setAttribute(Qt::WA_DeleteOnClose);
    search_->setPlaceholderText(tr("Search keys and what they do"));
    search_->setAccessibleName(tr("Search keys"));
    search_->setClearButtonEnabled(true);
    connect(search_, &QLineEdit::textChanged, this, &KeySheet::showMatching);
    text_->setTextFormat(Qt::RichText);
    text_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    text_->setWordWrap(true);
    text_->setContentsMargins(4, 0, 18, 0);
    auto* scroll = new QScrollArea;
    scroll->setProperty("role", "column");
    scroll->setWidget(text_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    auto* close = new QPushButton(tr("Close"));
    close->setProperty("role", "primary");
    close->setDefault(true);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 18, 20, 16);
    layout->setSpacing(14);
    layout->addWidget(search_);
    layout->addWidget(scroll, 1);
    layout->addWidget(close, 0, Qt::AlignRight);
    resize(600, 680);
    showMatching({});
    search_->setFocus();
}

void KeySheet::showMatching(const QString& words)
{
    std::vector<KeyLine> shown;
    std::ranges::copy_if(lines_, std::back_inserter(shown),
                         [&words](const KeyLine& line) { return matches(line, words); });
    text_->setText(shown.empty() ? tr("No key for “%1”.").arg(words.toHtmlEscaped()) : tableOf(shown));
}

}   // namespace ui
