#include "ui/panels/play_bar.h"

#include "ui/actions/key_hint.h"
#include "ui/controls/glyph_button.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QComboBox>
#include <QHBoxLayout>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

/// Formats a playback speed, e.g. "½×"; the same in every language.
QString speedName(double speed)
{
    const QString number = speed == 0.25  ? QStringLiteral("¼")
                           : speed == 0.5 ? QStringLiteral("½")
                                          : QString::number(speed);
    return number + QStringLiteral("×");
}

int indexOfSpeed(double speed)
{
    const auto off = [speed](double offered) { return std::abs(std::log(offered / std::max(speed, 1e-3))); };
    return static_cast<int>(std::ranges::min_element(playSpeeds, {}, off) - playSpeeds.begin());
}

}   // namespace

PlayBar::PlayBar(QWidget* parent)
    : QWidget(parent),
      play_(new GlyphButton(GlyphButton::Glyph::Play)),
      speed_(new QComboBox),
      order_(new GlyphButton(GlyphButton::Glyph::Loop))
{
    play_->setObjectName(QStringLiteral("playButton"));
    speed_->setObjectName(QStringLiteral("playSpeed"));
    order_->setObjectName(QStringLiteral("playOrder"));
    for (const double speed : playSpeeds) {
        speed_->addItem(speedName(speed));
    }
    speed_->setFixedHeight(play_->sizeHint().height());
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    for (QWidget* part : std::initializer_list<QWidget*>{play_, speed_, order_}) {
        layout->addWidget(part);
    }
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(play_, &GlyphButton::clicked, this, &PlayBar::playClicked);
    connect(speed_, &QComboBox::activated, this,
            [this](int place) { emit speedPicked(playSpeeds.at(static_cast<std::size_t>(place))); });
    connect(order_, &GlyphButton::clicked, this, [this] {
        emit orderPicked(shownOrder_ == core::CineOrder::Loop ? core::CineOrder::BackAndForth : core::CineOrder::Loop);
    });
    showSpeed(1.0);
    keepTranslated(this, [this] { updateTexts(); });
}

void PlayBar::showFrameTime(const FrameTime& time)
{
    frameTime_ = time;
    updateTexts();
}

void PlayBar::showSpeed(double speed)
{
    speed_->setCurrentIndex(indexOfSpeed(speed));
}

void PlayBar::showOrder(core::CineOrder order)
{
    shownOrder_ = order;
    order_->showGlyph(order == core::CineOrder::Loop ? GlyphButton::Glyph::Loop : GlyphButton::Glyph::BackAndForth);
    updateTexts();
}

void PlayBar::showPlaying(bool playing)
{
    isPlaying_ = playing;
    play_->showGlyph(playing ? GlyphButton::Glyph::Pause : GlyphButton::Glyph::Play);
    updateTexts();
}

void PlayBar::updateTexts()
{
    play_->setAccessibleName(isPlaying_ ? tr("Pause") : tr("Play"));
    play_->setToolTip(
        isPlaying_
            ? tooltipWithShortcut(tr("Stops at the current frame. Esc returns to the frame shown before playback."),
                                  Command::Cine)
            : tooltipWithShortcut(tr("Plays the run"), Command::Cine));
    const bool isLoop = shownOrder_ == core::CineOrder::Loop;
    order_->setAccessibleName(isLoop ? tr("Loop") : tr("Back and forth"));
    order_->setToolTip(order_->accessibleName());
    speed_->setAccessibleName(tr("Speed"));
    if (frameTime_.ms <= 0.0) {
        return;
    }
    for (std::size_t i = 0; i < playSpeeds.size(); ++i) {
        const double rate = 1000.0 / frameTime_.ms * playSpeeds.at(i);
        speed_->setItemText(static_cast<int>(i),
                            tr("%1 · %2 fps").arg(speedName(playSpeeds.at(i)), briefNumber(rate, 3)));
    }
    const QString rate = briefNumber(1000.0 / frameTime_.ms, 3);
    speed_->setToolTip(
        frameTime_.isAssumed
            ? tr("The header contains no frame rate: 1× corresponds to an assumed rate of %1 frames per second")
                  .arg(rate)
            : tr("1×: acquisition frame rate, %1 frames per second").arg(rate));
}

}   // namespace angiopose::ui
