#pragma once

#include <QObject>

namespace angiopose::ui {
class MainWindow;
enum class ColorScheme;
}   // namespace angiopose::ui
namespace angiopose::app {

/// The menu of colours for vessels and residuals, each readable with any colour vision.
class ColorController : public QObject {
    Q_OBJECT
public:
    explicit ColorController(ui::MainWindow& window, QObject* parent = nullptr);

private:
    void apply(ui::ColorScheme scheme);

    ui::MainWindow& window_;
};

}   // namespace angiopose::app