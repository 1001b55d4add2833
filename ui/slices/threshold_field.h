#pragma once

#include <QWidget>

#include <optional>
#include <utility>

class QCheckBox;
class QSlider;

namespace angiopose::ui {

class NumberField;

/// The value of a scan at which its vessels begin: found, or chosen by slider and number. Shows what it is told.
class ThresholdField : public QWidget {
    Q_OBJECT
public:
    explicit ThresholdField(QWidget* parent = nullptr);

    /// Values that it can have, in Hounsfield units or in the scan's own.
    void showRange(std::pair<double, double> range, bool isHounsfield);
    void showChosen(std::optional<double> threshold);   ///< nothing: automatic
    void showFound(std::optional<double> threshold);   ///< what "automatic" comes to, when known
    bool isPreviewWanted() const;
    std::optional<double> shown() const;   ///< chosen, or found

signals:
    void chosen(std::optional<double> threshold);
    void previewChanged();

private:
    QLayout* valueRow();
    void choose(std::optional<double> threshold);
    void showValues();

    std::optional<double> chosen_;
    std::optional<double> found_;
    bool isHounsfield_ = true;
    QCheckBox* automatic_;
    NumberField* value_;
    QSlider* slider_;
    QCheckBox* preview_;
};

}   // namespace angiopose::ui
