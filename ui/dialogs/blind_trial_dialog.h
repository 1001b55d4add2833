#pragma once

#include <QDialog>

#include <cstdint>

class QLineEdit;
class QFormLayout;
class QHBoxLayout;
class QPushButton;

namespace angiopose::ui {

class NumberField;

/// Settings of a blind trial.
struct BlindTrialSetup {
    QString observer;
    std::uint64_t seed = 1;
    double rangeMm = 15.0;
    double rangeDeg = 8.0;
    QString logPath;   ///< path of a CSV file with one row per trial
};

/// Asks for the observer, the range of initial poses, the seed and the log file of a blind trial.
class BlindTrialDialog : public QDialog {
    Q_OBJECT
public:
    BlindTrialDialog(const BlindTrialSetup& suggested, QWidget* parent);

signals:
    void startRequested(const ui::BlindTrialSetup& setup);

private:
    QWidget* makeIntroduction();
    QFormLayout* makeForm();
    QHBoxLayout* makeLogRow();
    QHBoxLayout* makeButtons();
    BlindTrialSetup setup() const;
    void chooseLog();
    void updateButton();

    QLineEdit* observer_;
    NumberField* seed_;
    NumberField* rangeMm_;
    NumberField* rangeDeg_;
    QLineEdit* log_;
    QPushButton* start_;
};

}   // namespace angiopose::ui
