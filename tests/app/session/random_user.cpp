#include "tests/app/session/random_user.h"

#include "ui/panels/number_field.h"
#include "ui/slices/slice_view.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QListView>
#include <QMenu>
#include <QStandardPaths>
#include <QTest>
#include <QWheelEvent>

#include <array>
#include <vector>

namespace test {
namespace {

struct Press {
    Qt::Key key;
    Qt::KeyboardModifiers modifiers = Qt::NoModifier;
};

/// Every key of the key sheet but Quit and those that open file dialogs.
const std::vector<Press>& presses()
{
    using enum Qt::Key;
    static const std::vector<Press> keys{{Key_N},
                                         {Key_N},
                                         {Key_Left},
                                         {Key_Right},
                                         {Key_Up},
                                         {Key_Down},
                                         {Key_Left, Qt::ShiftModifier},
                                         {Key_Right, Qt::ControlModifier},
                                         {Key_Up, Qt::AltModifier},
                                         {Key_Left, Qt::AltModifier},
                                         {Key_PageUp},
                                         {Key_PageDown, Qt::ShiftModifier},
                                         {Key_Comma},
                                         {Key_Period},
                                         {Key_Home},
                                         {Key_End},
                                         {Key_Backspace},
                                         {Key_A},
                                         {Key_X},
                                         {Key_A, Qt::ControlModifier},
                                         {Key_R},
                                         {Key_R, Qt::ShiftModifier},
                                         {Key_1},
                                         {Key_0},
                                         {Key_3},
                                         {Key_I},
                                         {Key_O},
                                         {Key_T},
                                         {Key_F},
                                         {Key_C},
                                         {Key_D},
                                         {Key_S},
                                         {Key_W},
                                         {Key_U},
                                         {Key_P},
                                         {Key_J},
                                         {Key_J, Qt::ShiftModifier},
                                         {Key_V},
                                         {Key_V, Qt::ShiftModifier},
                                         {Key_7},
                                         {Key_8},
                                         {Key_9},
                                         {Key_BracketLeft},
                                         {Key_BracketRight},
                                         {Key_P, Qt::ShiftModifier},
                                         {Key_Z, Qt::ControlModifier},
                                         {Key_Z, Qt::ControlModifier},
                                         {Key_Z, Qt::ControlModifier},
                                         {Key_Y, Qt::ControlModifier},
                                         {Key_Y, Qt::ControlModifier},
                                         {Key_C, Qt::ControlModifier},
                                         {Key_M},
                                         {Key_2},
                                         {Key_Delete},
                                         {Key_Delete, Qt::ShiftModifier},
                                         {Key_K, Qt::ControlModifier},
                                         {Key_J, Qt::ControlModifier},
                                         {Key_M, Qt::ControlModifier},
                                         {Key_H, Qt::ShiftModifier},
                                         {Key_H, Qt::ControlModifier | Qt::ShiftModifier},
                                         {Key_Home, Qt::ControlModifier},
                                         {Key_G, Qt::ControlModifier},
                                         {Key_F2},
                                         {Key_P, Qt::ControlModifier},
                                         {Key_T, Qt::ControlModifier},
                                         {Key_E},
                                         {Key_E},
                                         {Key_B},
                                         {Key_B, Qt::ShiftModifier},
                                         {Key_B, Qt::ControlModifier},
                                         {Key_C, Qt::ShiftModifier},
                                         {Key_G},
                                         {Key_L},
                                         {Key_Return},
                                         {Key_Escape},
                                         {Key_Escape},
                                         {Key_L},
                                         {Key_L, Qt::ShiftModifier},
                                         {Key_Return},
                                         {Key_Delete},
                                         {Key_Q},
                                         {Key_Backspace, Qt::ShiftModifier},
                                         {Key_Backspace, Qt::ControlModifier},
                                         {Key_K},
                                         {Key_Y},
                                         {Key_Y},
                                         {Key_4},
                                         {Key_5},
                                         {Key_F7},
                                         {Key_F8},
                                         {Key_F8},
                                         {Key_L, Qt::ControlModifier},
                                         {Key_C, Qt::ControlModifier | Qt::ShiftModifier},
                                         {Key_F1, Qt::ControlModifier},
                                         {Key_F1}};
    return keys;
}

template <class Widget>
std::vector<Widget*> usable(QWidget& window)
{
    std::vector<Widget*> found;
    for (Widget* widget : window.findChildren<Widget*>()) {
        if (widget->isVisible() && widget->isEnabled() && widget->window() == &window && !widget->size().isEmpty() &&
            !widget->visibleRegion().isEmpty()) {
            found.push_back(widget);
        }
    }
    return found;
}

/// Buttons whose click leads out of the window or throws the case away.
bool leadsAway(const QAbstractButton& button)
{
    return button.text().contains(QStringLiteral("Open")) || button.text().contains(QStringLiteral("Quit"));
}

}   // namespace

RandomUser::RandomUser(ui::MainWindow& window, app::CaseController& controller, std::uint64_t seed)
    : window_(window),
      controller_(controller),
      random_(seed),
      folder_(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation))
{
}

int RandomUser::below(int count)
{
    return static_cast<int>(random_() % static_cast<std::uint64_t>(std::max(1, count)));
}

double RandomUser::between(double low, double high)
{
    return low + (high - low) * (static_cast<double>(random_() >> 11U) * 0x1.0p-53);
}

QPoint RandomUser::somewhereIn(const QWidget& widget)
{
    return {below(widget.width()), below(widget.height())};
}

void RandomUser::act()
{
    struct Choice {
        int weight;
        void (RandomUser::*action)();
    };
    static constexpr std::array choices{Choice{40, &RandomUser::pressKey},    Choice{3, &RandomUser::holdKey},
                                        Choice{14, &RandomUser::dragInImage}, Choice{10, &RandomUser::wheelOverImage},
                                        Choice{8, &RandomUser::clickInImage}, Choice{5, &RandomUser::workInTreeView},
                                        Choice{6, &RandomUser::clickBranch},  Choice{4, &RandomUser::workInSlices},
                                        Choice{5, &RandomUser::typeNumber},   Choice{3, &RandomUser::changeChoice},
                                        Choice{4, &RandomUser::clickButton},  Choice{1, &RandomUser::resizeWindow},
                                        Choice{1, &RandomUser::saveAndExport}};
    int total = 0;
    for (const Choice& choice : choices) {
        total += choice.weight;
    }
    int draw = below(total);
    for (const Choice& choice : choices) {
        draw -= choice.weight;
        if (draw < 0) {
            (this->*choice.action)();
            break;
        }
    }
    QApplication::processEvents();
    closeDialogs();
}

void RandomUser::pressKey()
{
    const Press press = presses()[static_cast<std::size_t>(below(static_cast<int>(presses().size())))];
    note(QStringLiteral("key ") + QKeySequence(press.key | press.modifiers).toString());
    window_.angiogramView().setFocus();
    QTest::keyClick(&window_.angiogramView(), press.key, press.modifiers);
}

void RandomUser::holdKey()
{
    note(QStringLiteral("hold H"));
    QTest::keyPress(&window_.angiogramView(), Qt::Key_H);
    QApplication::processEvents();
    QTest::keyRelease(&window_.angiogramView(), Qt::Key_H);
}

void RandomUser::drag(QWidget& widget, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    QPoint at = somewhereIn(widget);
    QTest::mousePress(&widget, button, modifiers, at);
    const int steps = 2 + below(6);
    for (int i = 0; i < steps; ++i) {
        at += QPoint(below(41) - 20, below(41) - 20);
        QTest::mouseMove(&widget, at);
        QApplication::processEvents();
    }
    if (below(8) == 0) {
        QTest::keyClick(&widget, Qt::Key_Escape);
    }
    QTest::mouseRelease(&widget, button, modifiers, at);
}

void RandomUser::dragInImage()
{
    static constexpr std::array buttons{Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton, Qt::RightButton};
    const Qt::MouseButton button = buttons[static_cast<std::size_t>(below(4))];
    note(QStringLiteral("drag in image with button %1").arg(static_cast<int>(button)));
    drag(window_.angiogramView(), button, below(4) == 0 ? Qt::ControlModifier : Qt::NoModifier);
}

void RandomUser::wheelOverImage()
{
    note(QStringLiteral("wheel"));
    QWidget& view = window_.angiogramView();
    const QPointF at = somewhereIn(view);
    QWheelEvent event(at, view.mapToGlobal(at), {}, {0, below(2) == 0 ? 120 : -120}, Qt::NoButton,
                      below(2) == 0 ? Qt::ControlModifier : Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
}

void RandomUser::clickInImage()
{
    QWidget& view = window_.angiogramView();
    const QPoint at = somewhereIn(view);
    QTest::mouseMove(&view, at);
    if (below(5) == 0) {
        note(QStringLiteral("double click in image"));
        QTest::mouseDClick(&view, Qt::LeftButton, {}, at);
    } else {
        note(QStringLiteral("click in image"));
        QTest::mouseClick(&view, Qt::LeftButton, below(3) == 0 ? Qt::ControlModifier : Qt::NoModifier, at);
    }
}

void RandomUser::workInTreeView()
{
    note(QStringLiteral("3-D view"));
    QWidget& view = window_.treeView();
    if (!view.isVisible()) {
        return;
    }
    QTest::mouseMove(&view, somewhereIn(view));
    if (below(2) == 0) {
        drag(view, below(2) == 0 ? Qt::LeftButton : Qt::RightButton, Qt::NoModifier);
    } else {
        QTest::mouseClick(&view, Qt::LeftButton, {}, somewhereIn(view));
    }
}

void RandomUser::workInSlices()
{
    const auto views = usable<ui::SliceView>(window_);
    if (views.empty()) {
        return;
    }
    note(QStringLiteral("slices"));
    ui::SliceView& view = *views[static_cast<std::size_t>(below(static_cast<int>(views.size())))];
    static constexpr std::array keys{Qt::Key_Up, Qt::Key_PageDown, Qt::Key_Home, Qt::Key_Return};
    static constexpr std::array buttons{Qt::LeftButton, Qt::MiddleButton, Qt::RightButton};
    if (below(3) == 0) {
        QTest::keyClick(&view, keys[static_cast<std::size_t>(below(4))]);
    } else if (below(2) == 0) {
        QTest::mouseClick(&view, buttons[static_cast<std::size_t>(below(3))], {}, somewhereIn(view));
    } else {
        drag(view, buttons[static_cast<std::size_t>(below(3))], Qt::NoModifier);
    }
}

void RandomUser::clickBranch()
{
    note(QStringLiteral("branch list"));
    QListView& list = *window_.branches().list();
    if (list.isVisible()) {
        QWidget& port = *list.viewport();
        QTest::mouseMove(&port, somewhereIn(port));
        QTest::mouseClick(&port, Qt::LeftButton, below(3) == 0 ? Qt::ControlModifier : Qt::NoModifier,
                          somewhereIn(port));
    }
}

void RandomUser::typeNumber()
{
    const auto fields = usable<ui::NumberField>(window_);
    if (fields.empty()) {
        return;
    }
    ui::NumberField* field = fields[static_cast<std::size_t>(below(static_cast<int>(fields.size())))];
    const bool isPose = window_.pose().isAncestorOf(field);
    const double value = isPose ? between(-15.0, 15.0) : field->value().value_or(1.0) * between(0.9, 1.1);
    note(QStringLiteral("type %1 into %2").arg(value).arg(field->accessibleName()));
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QString::number(value, 'f', 2));
    QTest::keyClick(field, below(6) == 0 ? Qt::Key_Escape : Qt::Key_Return);
}

void RandomUser::changeChoice()
{
    const auto boxes = usable<QComboBox>(window_);
    if (boxes.empty()) {
        return;
    }
    QComboBox* box = boxes[static_cast<std::size_t>(below(static_cast<int>(boxes.size())))];
    note(QStringLiteral("choose in ") + box->accessibleName());
    box->setFocus();
    QTest::keyClick(box, below(2) == 0 ? Qt::Key_Down : Qt::Key_Up);
}

void RandomUser::clickButton()
{
    const auto buttons = usable<QAbstractButton>(window_);
    if (buttons.empty()) {
        return;
    }
    QAbstractButton* button = buttons[static_cast<std::size_t>(below(static_cast<int>(buttons.size())))];
    if (leadsAway(*button)) {
        return;
    }
    note(QStringLiteral("button ") + button->text() + button->accessibleName());
    QTest::mouseClick(button, Qt::LeftButton, {}, button->rect().center());
}

void RandomUser::resizeWindow()
{
    note(QStringLiteral("resize"));
    window_.resize(1000 + below(500), 650 + below(350));
    QApplication::processEvents();
}

void RandomUser::saveAndExport()
{
    note(QStringLiteral("save and export"));
    controller_.saving().saveTo(folder_ + QStringLiteral("/random.angiopose"));
    controller_.exporting().exportOverlay({300 + below(500), ui::Choice::On, ui::Choice::Off},
                                          folder_ + QStringLiteral("/random.png"));
}

void RandomUser::closeDialogs()
{
    for (int round = 0; round < 5; ++round) {
        QWidget* open = QApplication::activePopupWidget();
        for (QDialog* dialog : window_.findChildren<QDialog*>()) {
            open = dialog->isVisible() ? dialog : open;
        }
        if (!open) {
            return;
        }
        QTest::keyClick(open, Qt::Key_Escape);
        if (open->isVisible()) {
            open->close();
        }
        QApplication::processEvents();
    }
}

}   // namespace test
