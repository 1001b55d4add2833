#include "app/files/title_controller.h"

#include "app/preferences/private_mode.h"
#include "ui/panels/bottom_strip.h"
#include "ui/panels/header_bar.h"
#include "ui/words/retranslation.h"

namespace angiopose::app {

using namespace std::chrono_literals;

TitleController::TitleController(CaseDocument& document, SaveController& saveController, ui::HeaderBar& header,
                                 ui::BottomStrip& strip, QWidget& window, QObject* parent)
    : QObject(parent),
      document_(document),
      saveController_(saveController),
      header_(header),
      strip_(strip),
      window_(window)
{
    connect(&document_, &CaseDocument::changed, this, &TitleController::show);
    connect(&document_, &CaseDocument::stateChanged, this, &TitleController::show);
    connect(&document_.undoStack(), &QUndoStack::indexChanged, this, &TitleController::show);
    connect(&document_.undoStack(), &QUndoStack::cleanChanged, this, &TitleController::show);
    clock_.setInterval(5s);
    connect(&clock_, &QTimer::timeout, this, &TitleController::showSaveState);
    clock_.start();
    ui::keepTranslated(this, [this] { show(); });
}

void TitleController::show()
{
    const QString name = isPrivate() ? tr("Case") : QString::fromStdString(document_.current().title);
    const QString star = document_.hasUnsavedWork() ? QStringLiteral("*") : QString();
    const QString shown = document_.isEmpty() ? QString() : (name.isEmpty() ? tr("Untitled case") : name) + star;
    window_.setWindowTitle(shown.isEmpty() ? tr("AngioPose · not for clinical use")
                                           : tr("%1 · AngioPose · not for clinical use").arg(shown));
    header_.showTitle(shown);
    header_.showStudy(studyText());
    showSaveState();
}

void TitleController::showSaveState()
{
    strip_.showSaveState(saveController_.saveState());
}

QString TitleController::studyText() const
{
    const core::Case& current = document_.current();
    if (!current.shown().angiogram) {
        return {};
    }
    const core::StudyIdentity& identity = current.shown().angiogram->identity;
    QStringList parts;
    for (const std::string& part : {isPrivate() ? std::string() : identity.studyDate, identity.modality}) {
        if (!part.empty()) {
            parts << QString::fromStdString(part);
        }
    }
    const int count = current.shown().angiogram->frameCount();
    parts << (count > 1 ? tr("%1 frames").arg(count) : tr("1 frame"));
    return parts.join(QStringLiteral(" · "));
}

}   // namespace angiopose::app
