#pragma once

#include <QString>

class QAction;

namespace angiopose::ui {

/// One line of the key sheet.
struct KeyLine {
    QString heading;   ///< where the key works
    QString keys;
    QString effect;
    QAction* action = nullptr;   ///< whose key can be changed; null where it is fixed
};

}   // namespace angiopose::ui
