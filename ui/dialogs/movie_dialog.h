#pragma once

#include "ui/dialogs/export_dialog.h"

#include <functional>

class QPushButton;

namespace angiopose::ui {

enum class MovieFormat { Mp4, Gif };
enum class MoviePart { Run, Convergence, Turn };

/// Options of a movie export.
struct MovieChoice {
    MoviePart part = MoviePart::Run;
    MovieFormat format = MovieFormat::Mp4;
    int widthPx = 1024;
    double framesPerSecond = 15.0;
    Choice identity = Choice::Off;
    Choice english = Choice::Off;   ///< English labels even if the window uses another language
    Choice residualColors = Choice::Off;   ///< used in convergence movies only
};

/// Movie content that is available, and the result that given options would produce.
struct MovieOffer {
    bool hasRun = false;   ///< the angiogram has more than one frame
    bool hasConvergence = false;
    std::function<double(MoviePart)> usualPerSecond;
    struct Outcome {
        std::size_t pictures = 0;
        double seconds = 0.0;
        QSize size;
        QString words;   ///< description of the frame range and poses used
        QString problem;   ///< reason why the movie cannot be written; empty if it can
    };
    std::function<Outcome(const MovieChoice&)> outcomeOf;
};

/// Asks for content, format, size and frame rate of a movie. Emits `chosen` on Export.
class MovieDialog : public QDialog {
    Q_OBJECT
public:
    MovieDialog(MovieOffer offer, QWidget* parent);

    void showChoice(const MovieChoice& choice);   ///< shows the options; replaces unavailable ones
    MovieChoice choice() const;

signals:
    void chosen(const ui::MovieChoice& choice);

private:
    void fillParts();
    QFormLayout* makeForm();
    void showUsualRate();
    void showOutcome();

    MovieOffer offer_;
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
