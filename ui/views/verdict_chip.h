#pragma once

#include <QLabel>

namespace angiopose::ui {

enum class VerdictTone { Good, Doubtful, Bad };

/// How far the shown pose is to be trusted, at the top of an image in the middle, whatever else is in sight. Lets the
/// mouse through; words that the image is too narrow for end in dots.
class VerdictChip : public QLabel {
    Q_OBJECT
public:
    explicit VerdictChip(QWidget& image);

    void showVerdict(VerdictTone tone, const QString& words);   ///< no words: hidden
    VerdictTone tone() const { return tone_; }
    const QString& words() const { return words_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void place();

    VerdictTone tone_ = VerdictTone::Doubtful;
    QString words_;
};

}   // namespace angiopose::ui
