#pragma once

#include <QWidget>

class QAction;
class QMenu;
class QSlider;
class QToolButton;

namespace angiopose::ui {

/// Bar above the 3-D view with the rendering mode and opacity of the scan.
class ScanBar : public QWidget {
    Q_OBJECT
public:
    explicit ScanBar(QWidget* parent = nullptr);

    void fillMenu(const QList<QAction*>& actions);
    void showState(const QString& text, bool isShown);   ///< `isShown` shows the opacity slider
    void showStrength(double strength);   ///< 0…1; emits no signal

signals:
    void strengthChanged(double strength);

private:
    QToolButton* choice_;
    QMenu* menu_;
    QSlider* strength_;
};

}   // namespace angiopose::ui
