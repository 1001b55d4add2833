#include "ui/archive/path_field.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

namespace angiopose::ui {

PathField::PathField(const QString& name, QWidget* parent) : QWidget(parent), name_(name), line_(new QLineEdit)
{
    auto* choose = new QPushButton(QStringLiteral("…"));
    choose->setAutoDefault(false);
    choose->setToolTip(tr("Choose a file"));
    choose->setAccessibleName(tr("Choose a file: %1").arg(name));
    line_->setAccessibleName(name);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(line_, 1);
    layout->addWidget(choose);
    setFocusProxy(line_);
    connect(choose, &QPushButton::clicked, this, &PathField::choose);
}

void PathField::setPath(const QString& path)
{
    line_->setText(path);
}

QString PathField::path() const
{
    return line_->text().trimmed();
}

void PathField::choose()
{
    auto* dialog = new QFileDialog(this, name_, QFileInfo(path()).absolutePath());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &PathField::setPath);
    dialog->open();
}

}   // namespace angiopose::ui
