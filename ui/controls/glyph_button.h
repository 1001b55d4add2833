#pragma once

#include <QToolButton>

namespace angiopose::ui {

/// Tool button with a vector glyph in the text color, sharp at any scale. Requires an accessible name.
class GlyphButton : public QToolButton {
    Q_OBJECT
public:
    enum class Glyph { Play, Pause, Loop, BackAndForth, Pin, Remove };

    explicit GlyphButton(Glyph glyph, QWidget* parent = nullptr);

    void showGlyph(Glyph glyph);
    QSize sizeHint() const override { return {30, 24}; }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Glyph glyph_;
};

}   // namespace angiopose::ui
