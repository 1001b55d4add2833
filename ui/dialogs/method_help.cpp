#include "ui/dialogs/method_help.h"

#include <QFile>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

/// Resources of a static library are there only once asked for, and only from outside any namespace.
static void loadPages()
{
    Q_INIT_RESOURCE(method_help);
}

namespace ui {

MethodHelp::MethodHelp(const QString& methodId, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("methodHelp"));
    setWindowTitle(tr("About this method"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* text = new QTextBrowser;
    text->setMarkdown(page(methodId));
    text->setFrameShape(QFrame::NoFrame);
    text->setAccessibleName(tr("About this method"));
    auto* close = new QPushButton(tr("Close"));
    close->setProperty("role", "primary");
    close->setDefault(true);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 18, 20, 16);
    layout->setSpacing(14);
    layout->addWidget(text, 1);
    layout->addWidget(close, 0, Qt::AlignRight);
    resize(560, 640);
}

QString MethodHelp::page(const QString& methodId)
{
    loadPages();
    QFile file(QStringLiteral(":/help/methods/%1.md").arg(methodId));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}   // namespace ui
