#include "ui/panels/trial_bar.h"

#include "ui/actions/key_hint.h"
#include "ui/controls/section.h"
#include "ui/words/retranslation.h"

#include <QHBoxLayout>
#include <QPushButton>

namespace angiopose::ui {

TrialBar::TrialBar(QWidget* parent) : QWidget(parent), label_(roleLabel("attention"))
{
    setProperty("role", "column");
    setAttribute(Qt::WA_StyledBackground);
    auto* abandon = withText(new QPushButton, [] { return tr("Abandon"); });
    withToolTip(abandon, [] { return tr("Ends the trial and logs it as abandoned."); });
    auto* done = withText(new QPushButton, [] { return withShortcut(tr("Done"), Command::FinishTrial); });
    done->setProperty("role", "primary");
    withAccessibleName(done, [] { return tr("Done"); });
    withToolTip(done, [] {
        return tooltipWithShortcut(tr("Logs the time and the pose, and shows the values again."), Command::FinishTrial);
    });
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 6, 14, 6);
    layout->setSpacing(10);
    layout->addWidget(label_, 1);
    layout->addWidget(abandon);
    layout->addWidget(done);
    connect(done, &QPushButton::clicked, this, &TrialBar::finishRequested);
    connect(abandon, &QPushButton::clicked, this, &TrialBar::abandonRequested);
    hide();
    keepTranslated(this, [this] { updateText(); });
}

void TrialBar::showTrial(const QString& observer)
{
    observer_ = observer;
    updateText();
    show();
}

void TrialBar::updateText()
{
    label_->setText(tr("Blind trial by %1: align the vessels with the image. Values are shown again when you are done.")
                        .arg(observer_));
}

}   // namespace angiopose::ui
