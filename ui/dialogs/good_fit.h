#pragma once

#include <QDialog>

#include <array>

class QImage;
class QLabel;

namespace angiopose::ui {

/// Examples of correct and wrong fits, including correct fits that look wrong; correct ones first.
enum class FitExample { Right, Unopacified, Deformed, Shifted, Turned, Tilted };
inline constexpr int fitExampleCount = 6;

/// "What a good fit looks like": three good and three bad fits with one sentence each. Images appear once they are
/// rendered. Deletes itself when closed.
class GoodFit : public QDialog {
    Q_OBJECT
public:
    explicit GoodFit(QWidget* parent);

    void showExample(FitExample example, const QImage& image);
    void showProblem(const QString& reason);

private:
    QWidget* makeCell(FitExample example);

    std::array<QLabel*, fitExampleCount> exampleLabels_{};
};

}   // namespace angiopose::ui
