#pragma once

#include <QWidget>

#include <vector>

namespace ui {

/// The frames of a run as bars of opacification; a click or ← → shows another frame.
class FrameBars : public QWidget {
    Q_OBJECT
public:
    explicit FrameBars(QWidget* parent = nullptr);

    void showFrames(const std::vector<double>& opacification, int suggested);   ///< one value 0…1 per frame
    void showCurrent(int frame);
    QSize sizeHint() const override { return {400, 40}; }

signals:
    void frameRequested(int frame);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    int frameAt(double x) const;
    void request(int frame);

    std::vector<double> opacification_;
    int suggested_ = 0;
    int current_ = 0;
};

}   // namespace ui
