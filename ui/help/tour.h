#pragma once

#include <QPointer>
#include <QWidget>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace angiopose::ui {

/// Stop of the tour: a widget with its explanation.
struct TourStop {
    QPointer<QWidget> target;
    QString heading;
    QString text;
    QString leaveLabel{};   ///< label of the button that leaves this stop; "Next" if empty
    std::function<void()> onLeave{};   ///< called when that button is pressed; may be empty
};

/// Guided tour: a bubble that moves from widget to widget and explains each one. The window remains usable meanwhile.
/// Deletes itself at the end.
class Tour : public QWidget {
    Q_OBJECT
public:
    Tour(std::vector<TourStop> stops, QWidget* window);
    ~Tour() override;

    void goTo(int stop);   ///< shows a stop; ends the tour after the last one
    int current() const { return current_; }
    int stopCount() const { return static_cast<int>(stops_.size()); }

signals:
    void ended();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    class Frame;
    void showNextStop();
    void place();
    void end();
    QRect targetRect() const;   ///< rectangle of the target in window coordinates

    std::vector<TourStop> stops_;
    int current_ = 0;
    QLabel* heading_;
    QLabel* text_;
    QLabel* count_;
    QPushButton* back_;
    QPushButton* next_;
    QPointer<QWidget> frame_;   ///< outline around the target
};

}   // namespace angiopose::ui
