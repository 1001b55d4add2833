#pragma once

#include <QObject>

class QAction;
class QWidget;

namespace angiopose::app {

/// Private mode, on and off: asks before it forgets, and clears up when the window goes.
class PrivacyController : public QObject {
    Q_OBJECT
public:
    PrivacyController(QAction& mode, QWidget& dialogParent, QObject* parent = nullptr);
    ~PrivacyController() override;

signals:
    void changed();   ///< what is remembered and shown is another now

private:
    void choose(bool on);
    void turnOn();
    void turnOff();

    QAction& mode_;
    QWidget& dialogParent_;
};

}   // namespace angiopose::app
