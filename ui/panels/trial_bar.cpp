#include "ui/panels/trial_bar.h"

#include "ui/actions/key_hint.h"
#include "ui/controls/section.h"
#include "ui/words/spoken.h"

#include <QHBoxLayout>
#include <QPushButton>

namespace angiopose::ui {

TrialBar::TrialBar(QWidget* parent) : QWidget(parent), words_(roleLabel("attention"))
{
    setProperty("role", "column");
    setAttribute(Qt::WA_StyledBackground);
    auto* abandon = withText(new QPushButton, [] { return tr("Abandon"); });
    withTip(abandon, [] { return tr("Ends the trial and logs it as abandoned."); });
    auto* done = withText(new QPushButton, [] { return withKey(tr("Done"), Command::TrialDone); });
    done->setProperty("role", "primary");
    withName(done, [] { return tr("Done"); });
    withTip(done, [] { return tipWithKey(tr("Logs time and pose and shows the values again."), Command::TrialDone); });
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 6, 14, 6);
    layout->setSpacing(10);
    layout->addWidget(words_, 1);
    layout->addWidget(abandon);
    layout->addWidget(done);
    connect(done, &QPushButton::clicked, this, &TrialBar::doneRequested);
    connect(abandon, &QPushButton::clicked, this, &TrialBar::abandonRequested);
    hide();
    speak(this, [this] { sayWhoseTrial(); });
}

void TrialBar::showTrial(const QString& observer)
{
    observer_ = observer;
    sayWhoseTrial();
    show();
}

void TrialBar::sayWhoseTrial()
{
    words_->setText(
        tr("Blind trial of %1: align the vessels with the image. Values reappear when you are done.").arg(observer_));
}

}   // namespace angiopose::ui
