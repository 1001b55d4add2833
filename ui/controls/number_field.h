#pragma once

#include <QLineEdit>
#include <QObject>
#include <optional>

namespace angiopose::ui {

enum class NumberSign { WhenNegative, Always };

/// What a number field accepts and how it shows it.
struct NumberFormat {
    double min = 0.0;
    double max = 0.0;
    int decimals = 0;
    QString unit;
    double step = 1.0;   ///< of arrow keys and wheel; Shift ten times, Ctrl a tenth
    NumberSign sign = NumberSign::WhenNegative;
};

/// A number with its unit in hint tone inside the field. Accepts '.' and ','; the wheel turns it only while it has
/// the focus; Enter or leaving commits, Esc takes the typing back.
class NumberField : public QLineEdit {
    Q_OBJECT
public:
    explicit NumberField(NumberFormat format, QWidget* parent = nullptr);

    void showValue(std::optional<double> value);   ///< silent; leaves text alone that the user is typing
    std::optional<double> value() const { return value_; }
    void setUnit(const QString& unit);
    void setDecimals(int decimals) { format_.decimals = decimals; }   ///< of what is shown next
    void setAsking(bool asking);   ///< glows: somebody should type or confirm this

signals:
    void edited(double value);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    QSize sizeHint() const override;

private:
    void commit();
    void revert();
    void stepBy(double steps, Qt::KeyboardModifiers modifiers);
    QString textOf(std::optional<double> value) const;

    NumberFormat format_;
    std::optional<double> value_;
};

/// The wheel turns a number or a choice only while that has the keys, and else scrolls what lies around it: nobody
/// changes a case in passing. Holds for every box of the application, those of dialogs too.
class WheelGuard : public QObject {
    Q_OBJECT
public:
    explicit WheelGuard(QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}   // namespace angiopose::ui
