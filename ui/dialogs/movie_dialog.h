#pragma once

#include "ui/dialogs/export_dialog.h"

#include <functional>

class QPushButton;

namespace angiopose::ui {

enum class MovieFormat { Mp4, Gif };
enum class MoviePart { Run, Convergence, Rotation };

/// Options of a movie export.
struct MovieOptions {
    MoviePart part = MoviePart::Run;
    MovieFormat format = MovieFormat::Mp4;
    int widthPx = 1024;
    double framesPerSecond = 15.0;
    Toggle identity = Toggle::Off;
    Toggle english = Toggle::Off;   ///< whether to use English labels even if the UI language is another
    Toggle residualColors = Toggle::Off;   ///< whether to show residual colors; used in convergence movies only
};

/// Movie content that is available, and what the selected options would produce.
struct AvailableMovies {
    bool hasRun = false;   ///< true if the angiogram has more than one frame
    bool hasConvergence = false;
    std::function<double(MoviePart)> defaultFrameRate;
    struct Outcome {
        std::size_t imageCount = 0;
        double seconds = 0.0;
        QSize size;
        QString description;   ///< description of the frame range and of the poses used
        QString problem;   ///< reason why the movie cannot be written; empty if it can
    };
    std::function<Outcome(const MovieOptions&)> outcomeOf;
};

/// Asks for content, format, size and frame rate of a movie. Emits `chosen` on Export.
class MovieDialog : public QDialog {
    Q_OBJECT
public:
    MovieDialog(AvailableMovies available, QWidget* parent);

    void showOptions(const MovieOptions& exportOptions);   ///< shows the options; replaces those that are unavailable
    MovieOptions exportOptions() const;

signals:
    void chosen(const ui::MovieOptions& exportOptions);

private:
    void fillParts();
    QFormLayout* makeForm();
    void showDefaultRate();
    void showOutcome();

    AvailableMovies availableMovies_;
    QComboBox* part_;
    QComboBox* format_;
    NumberField* width_;
    NumberField* rate_;
    QLabel* outcome_;
    QCheckBox* residuals_;
    QCheckBox* identity_;
    QCheckBox* english_;
    QPushButton* export_;
};

}   // namespace angiopose::ui
