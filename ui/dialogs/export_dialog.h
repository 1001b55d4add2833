#pragma once

#include <QDialog>
#include <QSize>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;

namespace angiopose::ui {

class NumberField;

enum class Choice { Off, On };

enum class PictureFormat { Png, Svg, Pdf };
enum class PicturePart { Overlay, Frame, Frame16 };

/// How the user wants the overlay exported.
struct ExportChoice {
    int widthPx = 1024;
    Choice residualColors = Choice::On;
    Choice identity = Choice::Off;
    Choice english = Choice::Off;   ///< texts in the picture, where the window speaks another language
    Choice cutout = Choice::Off;   ///< swipe or lens, where the window has one
    Choice startBeside = Choice::Off;   ///< a second picture with the vessels at the start pose
    PictureFormat format = PictureFormat::Png;
    PicturePart part = PicturePart::Overlay;   ///< grey values of 16 bit: PNG alone, at the frame's own size
    int dotsPerInch = 300;
};

/// Asks what, as what, how large and with what before an overlay is written. `chosen` follows on Export.
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
    void showSize();
    void showPart();

    int viewWidthPx_;
    double aspect_;
    QComboBox* part_;
    QComboBox* format_;
    QComboBox* size_;
    NumberField* width_;
    QLabel* widthLabel_;
    NumberField* resolution_;
    QLabel* resulting_;
    QCheckBox* residuals_;
    QCheckBox* identity_;
    QCheckBox* english_;
    QCheckBox* cutout_;
    QCheckBox* startBeside_;
};

/// What the user wants to have as DICOM objects, in the order of the boxes.
enum class DicomPart { Picture, Run, Report, State, Registration, Segmentation, Measurements };

struct DicomChoice {
    std::vector<DicomPart> parts;
    Choice identity = Choice::Off;   ///< burned into pictures and report
};

enum class DicomPurpose { Export, Send };

/// Asks which DICOM objects are made of a case. What the case does not allow cannot be chosen. `chosen` follows on
/// Export, or on the way to an archive.
class DicomDialog : public QDialog {
    Q_OBJECT
public:
    /// `possible` can be chosen, and is at first.
    DicomDialog(const std::vector<DicomPart>& possible, DicomPurpose purpose, QWidget* parent);

    DicomChoice choice() const;

signals:
    void chosen(const ui::DicomChoice& choice);

private:
    void showState();

    std::vector<QCheckBox*> boxes_;   ///< one for each part
    QCheckBox* identity_;
    QPushButton* export_;
};

}   // namespace angiopose::ui
