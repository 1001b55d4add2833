#pragma once

#include <QObject>

namespace angiopose::ui {

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