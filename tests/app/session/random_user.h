#pragma once

#include "app/case_controller.h"
#include "ui/main_window.h"

#include <QPointer>

#include <random>

namespace test {

/// A user who does anything the window allows, in random order, by real mouse and key events. The same seed always
/// makes the same choices.
class RandomUser {
public:
    RandomUser(ui::MainWindow& window, app::CaseController& controller, std::uint64_t seed);

    void act();   ///< one action, and whatever dialog it opened closed again
    const QString& lastAction() const { return last_; }

private:
    int below(int count);
    double between(double low, double high);
    QPoint somewhereIn(const QWidget& widget);
    void note(const QString& action) { last_ = action; }

    void pressKey();
    void holdKey();
    void dragInImage();
    void wheelOverImage();
    void clickInImage();
    void workInTreeView();
    void workInSlices();
    void clickBranch();
    void typeNumber();
    void changeChoice();
    void clickButton();
    void resizeWindow();
    void saveAndExport();
    void drag(QWidget& widget, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);
    void closeDialogs();

    ui::MainWindow& window_;
    app::CaseController& controller_;
    std::mt19937_64 random_;
    QString last_;
    QString folder_;
};

}   // namespace test
