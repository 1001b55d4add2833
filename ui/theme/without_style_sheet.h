#pragma once

#include <QString>

#include <optional>

namespace angiopose::ui {

/// Removes the application's style sheet while this object exists, unless windows are already visible. With a style
/// sheet, Qt restyles a widget and all its children whenever its parent changes, which happens a dozen times while
/// layouts build a window (measured: 40 % of the time to the first window).
class WithoutStyleSheet {
public:
    WithoutStyleSheet();
    ~WithoutStyleSheet();
    WithoutStyleSheet(const WithoutStyleSheet&) = delete;
    WithoutStyleSheet& operator=(const WithoutStyleSheet&) = delete;

private:
    std::optional<QString> sheet_;   ///< style sheet to restore; nullopt if none was removed
};

}   // namespace angiopose::ui
