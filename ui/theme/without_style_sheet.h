#pragma once

#include <QString>

#include <optional>

namespace angiopose::ui {

/// Takes the application's style sheet off while it lives, and puts it on again. Where windows are shown already it
/// leaves them and the sheet alone.
/// Under a sheet Qt dresses a widget with all its children anew at each change of parent; a window that is put together
/// from parts, as every layout does, would be dressed a dozen times (measured: 40 % of the time to the first window).
class WithoutStyleSheet {
public:
    WithoutStyleSheet();
    ~WithoutStyleSheet();
    WithoutStyleSheet(const WithoutStyleSheet&) = delete;
    WithoutStyleSheet& operator=(const WithoutStyleSheet&) = delete;

private:
    std::optional<QString> sheet_;   ///< what was taken off
};

}   // namespace angiopose::ui
