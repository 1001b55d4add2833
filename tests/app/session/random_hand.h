#pragma once

#include <QKeySequence>
#include <QPoint>
#include <QWidget>

#include <cstdint>
#include <random>
#include <vector>

namespace angiopose::test {

/// Generates random mouse and key events. The same seed generates the same sequence.
class RandomHand {
public:
    explicit RandomHand(std::uint64_t seed) : random_(seed) {}

    int below(int count);   ///< 0 … count − 1
    double between(double low, double high);
    bool oneIn(int times) { return below(times) == 0; }
    template <class Items>
    auto& oneOf(Items& items)
    {
        return items[static_cast<std::size_t>(below(static_cast<int>(std::size(items))))];
    }

    QPoint somewhereIn(const QWidget& widget);
    void press(QWidget& widget, const QKeySequence& keys);
    void click(QWidget& widget, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers modifiers = {});
    void drag(QWidget& widget, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {});   ///< sometimes with Esc
    void wheel(QWidget& widget);
    void askForMenu(QWidget& widget);   ///< sends only the context menu event of a right click

private:
    std::mt19937_64 random_;
};

/// The widgets of this type that a user can reach now.
template <class Widget>
std::vector<Widget*> usable(const QWidget& root)
{
    std::vector<Widget*> found;
    for (Widget* widget : root.findChildren<Widget*>()) {
        if (widget->isVisible() && widget->isEnabled() && widget->window() == root.window() &&
            !widget->size().isEmpty() && !widget->visibleRegion().isEmpty()) {
            found.push_back(widget);
        }
    }
    return found;
}

}   // namespace angiopose::test
