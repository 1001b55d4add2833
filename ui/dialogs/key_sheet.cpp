#include "ui/dialogs/key_sheet.h"

#include "ui/panels/section.h"

#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace ui {

KeySheet::KeySheet(const QString& richText, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("keySheet"));
    setWindowTitle(tr("Keys"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* text = roleLabel("body", richText);
    text->setTextFormat(Qt::RichText);
    text->setContentsMargins(4, 0, 18, 0);
    auto* scroll = new QScrollArea;
    scroll->setProperty("role", "column");
    scroll->setWidget(text);
    scroll->setFrameShape(QFrame::NoFrame);
    auto* close = new QPushButton(tr("Close"));
    close->setProperty("role", "primary");
    close->setDefault(true);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 18, 20, 16);
    layout->setSpacing(14);
    layout->addWidget(scroll, 1);
    layout->addWidget(close, 0, Qt::AlignRight);
    resize(560, 640);
}

}   // namespace ui
