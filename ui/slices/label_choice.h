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

/// Row of the label list.
struct LabelRow {
    int label = 0;
    QString name;   ///< empty if the file does not name the label
    double volumeMl = 0.0;
    Color color;   ///< color of the label in the slices

    bool operator==(const LabelRow&) const = default;
};

QString textOf(const LabelRow& row);   ///< returns the text of a row, e.g. "4  celiac_trunk", or "Label 4" if unnamed

/// List with check boxes that selects the vessel labels of a label image; long lists have a filter field. Passive view:
/// displays the given state and emits signals for user actions.
class LabelChoice : public QWidget {
    Q_OBJECT
public:
    explicit LabelChoice(QWidget* parent = nullptr);

    /// `suggested` holds the labels whose names denote vessels, if any.
    void showLabels(std::vector<LabelRow> rows, std::set<int> suggested);
    void showReading();   ///< shows that labels are still being read
    void showProblem(const QString& reason);   ///< shows the reason why reading failed
    void showNothing();   ///< hides the list for inputs without labels
    void showChosenLabels(const std::set<int>& labels);   ///< emits no signal
    const std::set<int>& chosenLabels() const { return chosenLabels_; }
    void setRunning(bool running);
    void focusList();

signals:
    void selectionEdited(const std::set<int>& labels);
    void currentRowChanged(int row);   ///< emitted when the current row has changed

private:
    QLayout* headRow();
    void replaceRows(std::vector<LabelRow> rows, std::set<int> suggested);
    void fill();
    void filter(const QString& text);
    void readCheckStates();
    void choose(std::optional<bool> ticked);   ///< for all filtered rows; if not set, checks the suggested ones
    void applyCheckStates();
    void scrollToFirstChecked();
    void updateTexts();
    void fitHeight();

    std::vector<LabelRow> rows_;
    std::set<int> suggested_;
    std::set<int> chosenLabels_;
    bool isReading_ = false;
    QString problem_;
    QPushButton* all_;
    QPushButton* none_;
    QPushButton* vessels_;
    QLineEdit* filter_;
    QTreeWidget* list_;
    QLabel* totalLabel_;
};

}   // namespace angiopose::ui
