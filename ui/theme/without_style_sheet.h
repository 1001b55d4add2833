#pragma once

#include <QString>

#include <optional>

namespace angiopose::ui {

/// Removes the application's style sheet during its lifetime and then restores it. Does nothing if windows are already
/// visible. With a style sheet, Qt restyles a widget and all its children at each change of parent; building a window
/// from layouts would restyle it a dozen times (measured: 40 % of the time to the first window).
class WithoutStyleSheet {
public:
    WithoutStyleSheet();
    ~WithoutStyleSheet();
    WithoutStyleSheet(const WithoutStyleSheet&) = delete;
    WithoutStyleSheet& operator=(const WithoutStyleSheet&) = delete;

private:
    std::optional<QString> sheet_;   ///< removed style sheet
};

}   // namespace angiopose::ui
