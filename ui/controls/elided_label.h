#pragma once

#include <QLabel>

namespace angiopose::ui {

/// A line of text that yields: what does not fit ends in "…" and stands whole in the tool tip.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(const char* role, QWidget* parent = nullptr);

    void showText(const QString& text);
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

}   // namespace angiopose::ui