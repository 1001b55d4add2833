#include "ui/dialogs/dialog_buttons.h"

#include <QDialog>
#include <QHBoxLayout>
#include <QPushButton>

namespace angiopose::ui {

QHBoxLayout* dialogButtons(QDialog& dialog, const QString& cancel, QPushButton& accept)
{
    auto* reject = new QPushButton(cancel);
    accept.setProperty("role", "primary");
    accept.setDefault(true);
    QObject::connect(reject, &QPushButton::clicked, &dialog, &QDialog::reject);
    QObject::connect(&accept, &QPushButton::clicked, &dialog, &QDialog::accept);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(reject);
    buttons->addWidget(&accept);
    return buttons;
}

}   // namespace angiopose::ui
