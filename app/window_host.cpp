#include "app/window_host.h"

#include "app/key_choice.h"
#include "app/language_choice.h"
#include "app/view_state.h"
#include "app/window_layout.h"

#include <utility>

namespace app {

using namespace std::chrono_literals;

WindowHost::WindowHost(QObject* parent) : QObject(parent), document_(std::make_shared<CaseDocument>())
{
    retry_.setSingleShot(true);
    retry_.setInterval(200ms);
    connect(&retry_, &QTimer::timeout, this, &WindowHost::renewWhenIdle);
    make();
    window_->show();
}

WindowHost::~WindowHost() = default;

void WindowHost::make()
{
    applyChosenKeys();
    window_ = std::make_unique<ui::MainWindow>();
    controller_ = std::make_unique<CaseController>(*window_, document_);
    // Queued: the choice comes from a menu or dialog of the window that goes.
    connect(&controller_->habits().language(), &LanguageController::chosen, this, &WindowHost::renewWhenIdle,
            Qt::QueuedConnection);
    connect(&controller_->habits().shortcuts(), &ShortcutController::keysChanged, this, &WindowHost::renewWhenIdle,
            Qt::QueuedConnection);
}

void WindowHost::renewWhenIdle()
{
    if (controller_->isBusy()) {
        window_->strip().showStatus(tr("Takes effect as soon as this has ended."));
        retry_.start();
        return;
    }
    renew();
}

void WindowHost::renew()
{
    storeWindowLayout(*window_);
    const ViewState seen = viewStateOf(*window_, *controller_);
    controller_.reset();
    const std::unique_ptr<ui::MainWindow> former = std::exchange(window_, nullptr);
    applyChosenLanguage();
    make();
    emit document_->changed();
    emit document_->stateChanged();
    window_->show();
    window_->activateWindow();
    emit renewed();
    // Once the views have their sizes.
    QTimer::singleShot(0, controller_.get(), [this, seen] { showAgain(seen, *window_, *controller_); });
}

}   // namespace app
