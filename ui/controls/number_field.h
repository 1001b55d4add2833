#pragma once

#include <QLineEdit>
#include <QObject>
#include <optional>

namespace angiopose::ui {

enum class NumberSign { WhenNegative, Always };

/// Range and display format of a number field.
struct NumberFormat {
    double min = 0.0;
    double max = 0.0;
    int decimals = 0;
    QString unit;
    double step = 1.0;   ///< increment of arrow keys and wheel; ×10 with Shift, ×0.1 with Ctrl
    NumberSign sign = NumberSign::WhenNegative;
};

/// Number field that shows its unit in a muted color. Accepts '.' and ','. The wheel changes the value only while the
/// field has focus; Enter or losing focus commits the value, Esc reverts it.
class NumberField : public QLineEdit {
    Q_OBJECT
public:
    explicit NumberField(NumberFormat format, QWidget* parent = nullptr);

    void showValue(std::optional<double> value);   ///< emits no signal; does not overwrite a value being typed
    std::optional<double> value() const { return value_; }
    void setUnit(const QString& unit);
    void setDecimals(int decimals) { format_.decimals = decimals; }   ///< takes effect at the next update
    void setHighlighted(bool isHighlighted);   ///< highlights a value that the user must enter or confirm

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

/// Lets the wheel change a combo box, spin box or slider only while it has focus; otherwise, to prevent accidental
/// edits, the wheel scrolls the surrounding area. Applies to the whole application, including dialogs.
class WheelGuard : public QObject {
    Q_OBJECT
public:
    explicit WheelGuard(QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}   // namespace angiopose::ui
