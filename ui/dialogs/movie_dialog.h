#pragma once

#include "ui/dialogs/export_dialog.h"

#include <functional>

class QPushButton;

namespace angiopose::ui {

enum class MovieFormat { Mp4, Gif };
enum class MoviePart { Run, Convergence, Turn };

/// How the user wants a movie.
struct MovieChoice {
    MoviePart part = MoviePart::Run;
    MovieFormat format = MovieFormat::Mp4;
    int widthPx = 1024;
    double framesPerSecond = 15.0;
    Choice identity = Choice::Off;
    Choice english = Choice::Off;   ///< texts in the pictures, where the window speaks another language
    Choice residualColors = Choice::Off;   ///< of a convergence
};

/// What there is to show, and what becomes of a choice.
struct MovieOffer {
    bool hasRun = false;   ///< of more than one frame
    bool hasConvergence = false;
    std::function<double(MoviePart)> usualPerSecond;
    struct Outcome {
        std::size_t pictures = 0;
        double seconds = 0.0;
        QSize size;
        QString words;   ///< what of the run, whose poses
        QString problem;   ///< why it cannot be written; empty: it can
    };
    std::function<Outcome(const MovieChoice&)> outcomeOf;
};

/// Asks what moves, as what, how large and how fast before a movie is written. `chosen` follows on Export.
class MovieDialog : public QDialog {
    Q_OBJECT
public:
    MovieDialog(MovieOffer offer, QWidget* parent);

    void showChoice(const MovieChoice& choice);   ///< what is not offered gives way
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
