#pragma once

#include <QDialog>
#include <QSize>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QHBoxLayout;
class QLabel;

namespace angiopose::ui {

class NumberField;

enum class Choice { Off, On };

/// How the user wants the overlay exported.
struct ExportChoice {
    int widthPx = 1024;
    Choice residualColors = Choice::On;
    Choice identity = Choice::Off;
    Choice english = Choice::Off;   ///< texts in the picture, where the window speaks another language
    Choice cutout = Choice::Off;   ///< swipe or lens, where the window has one
    Choice startBeside = Choice::Off;   ///< a second picture with the vessels at the start pose
};

/// Asks size, residual colours and identity before an overlay is written. `chosen` follows on Export.
class ExportDialog : public QDialog {
    Q_OBJECT
public:
    /// `viewWidthPx` is what the window shows now, `aspect` height by width of the picture.
    ExportDialog(int viewWidthPx, double aspect, QWidget* parent);

    void showChoice(const ExportChoice& choice);
    void offerCutout(bool hasCutout);   ///< on, where the window shows one
    ExportChoice choice() const;

signals:
    void chosen(const ui::ExportChoice& choice);

private:
    QFormLayout* makeForm();
    QHBoxLayout* makeButtons();
    void showSize();

    int viewWidthPx_;
    double aspect_;
    QComboBox* size_;
    NumberField* width_;
    QLabel* widthLabel_;
    QLabel* resulting_;
    QCheckBox* residuals_;
    QCheckBox* identity_;
    QCheckBox* english_;
    QCheckBox* cutout_;
    QCheckBox* startBeside_;
};

}   // namespace angiopose::ui