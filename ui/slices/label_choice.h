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

/// One label of a label image, as the list shows it.
struct LabelRow {
    int label = 0;
    QString name;   ///< empty where the file gives none
    double volumeMl = 0.0;
    Color color;   ///< as in the slices

    bool operator==(const LabelRow&) const = default;
};

QString textOf(const LabelRow& row);   ///< "4  celiac_trunk", or "Label 4"

/// Which labels of a label image are vessels: a list to tick, with a filter where it is long. Shows what it is told,
/// reports what the user wants.
class LabelChoice : public QWidget {
    Q_OBJECT
public:
    explicit LabelChoice(QWidget* parent = nullptr);

    /// `suggested` are those that are vessels by their names; empty: no name says so.
    void showLabels(std::vector<LabelRow> rows, std::set<int> suggested);
    void showReading();   ///< the labels are not known yet
    void showProblem(const QString& reason);   ///< why they are not
    void showNothing();   ///< what is traced has no labels: the list is hidden
    void showChosen(const std::set<int>& labels);   ///< silent
    const std::set<int>& chosen() const { return chosen_; }
    void setRunning(bool running);
    void focusList();

signals:
    void chosenEdited(const std::set<int>& labels);
    void rowShown(int row);   ///< the user is at this row of the list

private:
    QLayout* headRow();
    void replaceRows(std::vector<LabelRow> rows, std::set<int> suggested);
    void fill();
    void filter(const QString& text);
    void takeTicks();
    void choose(std::optional<bool> ticked);   ///< those that the filter lets through; nothing: the suggested ones
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