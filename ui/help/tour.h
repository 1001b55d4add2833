#pragma once

#include <QPointer>
#include <QWidget>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace angiopose::ui {

/// One thing the tour points at.
struct TourStop {
    QPointer<QWidget> target;
    QString heading;
    QString text;
    QString way{};   ///< on the button that goes on; empty: "Next"
    std::function<void()> onLeave{};   ///< called when that button is pressed here; may be empty
};

/// A bubble that goes from widget to widget and says what each is for. It lies in the window without blocking it: who
/// starts to work just works on. Deletes itself when it ends.
class Tour : public QWidget {
    Q_OBJECT
public:
    Tour(std::vector<TourStop> stops, QWidget* window);
    ~Tour() override;

    void goTo(int stop);   ///< past the last: ends
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
    void goOn();
    void place();
    void end();
    QRect targetRect() const;   ///< in the window

    std::vector<TourStop> stops_;
    int current_ = 0;
    QLabel* heading_;
    QLabel* text_;
    QLabel* count_;
    QPushButton* back_;
    QPushButton* next_;
    QPointer<QWidget> frame_;   ///< around the target
};

}   // namespace angiopose::ui