#include "app/habits/picture_controller.h"

#include "app/preferences/save_folder.h"
#include "ui/actions/window_actions.h"
#include "ui/dialogs/message_dialog.h"
#include "ui/panels/bottom_strip.h"

#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPixmap>

namespace angiopose::app {

PictureController::PictureController(ui::WindowActions& actions, ui::BottomStrip& strip, QWidget& window,
                                     QObject* parent)
    : QObject(parent), strip_(strip), window_(window)
{
    connect(actions[ui::Command::CopyWindow], &QAction::triggered, this, &PictureController::copy);
    connect(actions[ui::Command::SaveWindow], &QAction::triggered, this, &PictureController::askFile);
}

void PictureController::copy()
{
    QGuiApplication::clipboard()->setPixmap(window_.grab());
    strip_.showStatus(tr("The window is in the clipboard as a picture"));
}

void PictureController::askFile()
{
    const QPixmap picture = window_.grab();   // before the dialog covers it
    QMetaObject::invokeMethod(
        this, [this, picture] { askFileFor(picture); }, Qt::QueuedConnection);
}

void PictureController::askFileFor(const QPixmap& picture)
{
    const QString suggested = suggestedPath({}, QStringLiteral("angiopose.png"));
    auto* dialog = new QFileDialog(&window_, tr("Save picture of the window"), suggested, tr("PNG pictures (*.png)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, picture](const QString& path) {
        if (picture.save(path, "PNG")) {
            rememberSaveFolder(path);
            strip_.showStatus(tr("Written: %1").arg(QFileInfo(path).fileName()));
        } else {
            ui::MessageDialog::show(
                {tr("Could not save the picture"), tr("%1 could not be written. Choose another folder.").arg(path), {}},
                &window_);
        }
    });
    dialog->open();
}

}   // namespace angiopose::app