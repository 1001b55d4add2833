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

/// Options of an overlay export.
struct ExportChoice {
    int widthPx = 1024;
    Choice residualColors = Choice::On;
    Choice identity = Choice::Off;
    Choice english = Choice::Off;   ///< English labels although the window uses another language
    Choice cutout = Choice::Off;   ///< swipe or lens, if active in the window
    Choice startBeside = Choice::Off;   ///< second image with the vessels at the initial pose
    PictureFormat format = PictureFormat::Png;
    PicturePart part = PicturePart::Overlay;   ///< Frame16 (16-bit gray values): PNG only, native size
    int dotsPerInch = 300;
};

/// Asks for content, format, size and options of an overlay export. Emits `chosen` on Export.
class ExportDialog : public QDialog {
    Q_OBJECT
public:
    /// `viewWidthPx` is the current width of the view, `aspect` the height/width ratio of the image.
    ExportDialog(int viewWidthPx, double aspect, QWidget* parent);

    void showChoice(const ExportChoice& choice);
    void offerCutout(bool hasCutout);   ///< checked if the window shows a cutout
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

/// DICOM objects that can be exported, in the order of the check boxes.
enum class DicomPart { Picture, Run, Report, State, Registration, Segmentation, Measurements };

struct DicomChoice {
    std::vector<DicomPart> parts;
    Choice identity = Choice::Off;   ///< burned into images and report
};

enum class DicomPurpose { Export, Send };

/// Asks which DICOM objects to create from a case. Objects that the case cannot provide are disabled. Emits `chosen` on
/// Export or Send.
class DicomDialog : public QDialog {
    Q_OBJECT
public:
    /// The `possible` objects are enabled and initially checked.
    DicomDialog(const std::vector<DicomPart>& possible, DicomPurpose purpose, QWidget* parent);

    DicomChoice choice() const;

signals:
    void chosen(const ui::DicomChoice& choice);

private:
    void showState();

    std::vector<QCheckBox*> boxes_;   ///< one per DicomPart
    QCheckBox* identity_;
    QPushButton* export_;
};

}   // namespace angiopose::ui
