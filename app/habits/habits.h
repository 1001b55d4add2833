#pragma once

#include "app/habits/language_controller.h"

namespace app {

/// How each user likes the program to be: everything here is remembered between sessions, nothing belongs to a case.
class Habits {
public:
    explicit Habits(ui::MainWindow& window) : language_(window) {}

private:
    LanguageController language_;
};

}   // namespace app
