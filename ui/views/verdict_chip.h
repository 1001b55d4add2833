#pragma once

#include <QLabel>

namespace angiopose::ui {

enum class VerdictTone { Good, Doubtful, Bad };

/// Label with the confidence in the displayed pose, always visible at the top center of an image. Transparent for mouse
/// events; text that does not fit is elided.
class VerdictChip : public QLabel {
    Q_OBJECT
public:
    explicit VerdictChip(QWidget& image);

    void showVerdict(VerdictTone tone, const QString& fullText);   ///< an empty string hides the chip
    VerdictTone tone() const { return tone_; }
    const QString& fullText() const { return fullText_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void place();

    VerdictTone tone_ = VerdictTone::Doubtful;
    QString fullText_;
};

}   // namespace angiopose::ui
