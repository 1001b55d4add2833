#pragma once

#include "ui/theme/theme.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <set>
#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace angiopose::ui {

/// One row of the label list.
struct LabelRow {
    int label = 0;
    QString name;   ///< empty if the file gives none
    double volumeMl = 0.0;
    Color color;   ///< same as in the slices

    bool operator==(const LabelRow&) const = default;
};

QString textOf(const LabelRow& row);   ///< "4  celiac_trunk", or "Label 4"

/// Selects the vessel labels of a label image: a check list, with a filter if it is long. Displays the values it is
/// given and emits signals for user actions.
class LabelChoice : public QWidget {
    Q_OBJECT
public:
    explicit LabelChoice(QWidget* parent = nullptr);

    /// `suggested` holds the labels whose names denote vessels; empty: none do.
    void showLabels(std::vector<LabelRow> rows, std::set<int> suggested);
    void showReading();   ///< labels are still being read
    void showProblem(const QString& reason);   ///< reason why reading failed
    void showNothing();   ///< hides the list: the input has no labels
    void showChosen(const std::set<int>& labels);   ///< emits no signal
    const std::set<int>& chosen() const { return chosen_; }
    void setRunning(bool running);
    void focusList();

signals:
    void chosenEdited(const std::set<int>& labels);
    void rowShown(int row);   ///< the current row changed

private:
    QLayout* headRow();
    void replaceRows(std::vector<LabelRow> rows, std::set<int> suggested);
    void fill();
    void filter(const QString& text);
    void takeTicks();
    void choose(std::optional<bool> ticked);   ///< sets the filtered rows; empty: checks the suggested ones
    void setTicks();
    void showFirstTicked();
    void sayTexts();
    void fitHeight();

    std::vector<LabelRow> rows_;
    std::set<int> suggested_;
    std::set<int> chosen_;
    bool isReading_ = false;
    QString problem_;
    QPushButton* all_;
    QPushButton* none_;
    QPushButton* vessels_;
    QLineEdit* filter_;
    QTreeWidget* list_;
    QLabel* sum_;
};

}   // namespace angiopose::ui