#include "ui/dialogs/auxiliary_dialog.h"

#include "ui/actions/key_hint.h"
#include "ui/controls/number_field.h"
#include "ui/controls/section.h"
#include "ui/words/number.h"

#include <QGridLayout>
#include <QPushButton>

namespace angiopose::ui {
namespace {

constexpr int auxiliaryDialogWidth = 560;

QPushButton* makeButton(const QString& text, const QString& toolTip)
{
    auto* button = new QPushButton(text);
    button->setToolTip(toolTip);
    button->setAutoDefault(false);
    return button;
}

QLabel* wrapped(const char* role)
{
    QLabel* label = roleLabel(role);
    label->setWordWrap(true);
    return label;
}

}   // namespace

AuxiliaryDialog::AuxiliaryDialog(QWidget* parent)
    : QDialog(parent),
      suggestion_(wrapped("body")),
      preview_(wrapped("body")),
      generation_(new NumberField({0.0, 99.0, 0, {}, 1.0})),
      radius_(new NumberField({0.0, 50.0, 1, tr("mm"), 0.1})),
      byGeneration_(makeButton(tr("Up to generation"), tr("Generation 0 begins at the root of the tree."))),
      byRadius_(makeButton(tr("Radius at least"), tr("Uses the median radius of each branch."))),
      apply_(makeButton(tr("Use these"), tr("Selects the suggested branches as auxiliary branches."))),
      method_(makeButton({}, tr("This method alternates between the auxiliary branches and the whole vessel tree.")))
{
    setObjectName(QStringLiteral("auxiliaryDialog"));
    setWindowTitle(tr("Auxiliary branches"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(auxiliaryDialogWidth, 1);   // showAdvice sets the height to fit the text
    auto* words = wrapped("hint");
    words->setText(
        tr("Alternating methods solve for these branches first; choose branches that are opacified, stationary and "
           "clearly separated. In a view, a branch constrains the pose only perpendicular to its course; the table "
           "shows which branches constrain each axis at the current pose."));
    auto* suggested = new QHBoxLayout;
    suggested->setSpacing(8);
    suggested->addWidget(suggestion_, 1);
    suggested->addWidget(apply_, 0, Qt::AlignTop);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 16, 20, 14);
    layout->setSpacing(12);
    layout->addWidget(words);
    layout->addWidget(makeTable());
    layout->addLayout(suggested);
    layout->addLayout(makeSelectors());
    layout->addWidget(preview_);
    layout->addWidget(method_, 0, Qt::AlignLeft);
    layout->addStretch(1);
    connect(method_, &QPushButton::clicked, this, &AuxiliaryDialog::methodRequested);
    connect(apply_, &QPushButton::clicked, this, &AuxiliaryDialog::suggestionRequested);
    showAdvice({});
}

QWidget* AuxiliaryDialog::makeTable()
{
    auto* table = new QWidget;
    auto* grid = new QGridLayout(table);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(18);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(3, 1);
    const std::array headings{tr("Axis"), tr("All branches"), tr("Auxiliary"), tr("Constrained by")};
    for (int column = 0; column < 4; ++column) {
        grid->addWidget(roleLabel("hint", headings[static_cast<std::size_t>(column)]), 0, column);
        for (int row = 0; row < 6; ++row) {
            QLabel* cell = roleLabel(column == 0 ? "label" : "body");
            cells_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = cell;
            grid->addWidget(cell, row + 1, column);
        }
    }
    table->setToolTip(tr("±: standard deviation expected for traced vessels with typical noise."));
    return table;
}

QLayout* AuxiliaryDialog::makeSelectors()
{
    generation_->setAccessibleName(tr("Last generation"));
    radius_->setAccessibleName(tr("Minimum radius"));
    generation_->showValue(1.0);
    radius_->showValue(1.0);
    auto* lasso = makeButton(withShortcut(tr("Lasso"), Command::Lasso),
                             tooltipWithShortcut(tr("Draw around the branches in the image."), Command::Lasso));
    auto* inView = makeButton(
        withShortcut(tr("In view"), Command::AuxiliaryInView),
        tooltipWithShortcut(tr("Selects the branches that lie completely in the view."), Command::AuxiliaryInView));
    auto* none = makeButton(tr("None"), tr("Without auxiliary branches, the nodes of the vessel tree are used."));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(8);
    grid->addWidget(byGeneration_, 0, 0);
    grid->addWidget(generation_, 0, 1);
    grid->addWidget(lasso, 0, 2);
    grid->addWidget(byRadius_, 1, 0);
    grid->addWidget(radius_, 1, 1);
    grid->addWidget(inView, 1, 2);
    grid->addWidget(none, 1, 3);
    connect(lasso, &QPushButton::clicked, this, &AuxiliaryDialog::lassoRequested);
    connect(inView, &QPushButton::clicked, this, &AuxiliaryDialog::viewRequested);
    connect(none, &QPushButton::clicked, this, &AuxiliaryDialog::clearRequested);
    connect(byGeneration_, &QPushButton::clicked, this,
            [this] { emit generationRequested(static_cast<int>(generation_->value().value_or(0.0))); });
    connect(byRadius_, &QPushButton::clicked, this, [this] { emit radiusRequested(radius_->value().value_or(0.0)); });
    return grid;
}

void AuxiliaryDialog::showAdvice(const AuxiliaryAdvice& advice)
{
    for (std::size_t row = 0; row < cells_.size(); ++row) {
        const bool isKnown = row < advice.steps.size();
        const ParameterConstraint step = isKnown ? advice.steps[row] : ParameterConstraint{};
        const bool isAngle = step.unit == QStringLiteral("°");   // no space before the degree sign
        const auto plusMinus = [&step, isAngle](double std) {
            return (isAngle ? QStringLiteral("±%1%2") : QStringLiteral("±%1 %2")).arg(numberText(std, 2), step.unit);
        };
        cells_[row][0]->setText(step.name);
        cells_[row][1]->setText(isKnown ? plusMinus(step.stdAllBranches) : QString());
        cells_[row][2]->setText(isKnown ? plusMinus(step.stdAuxiliary) : QString());
        cells_[row][3]->setText(step.constrainedBy);
        setRole(cells_[row][2], isKnown && step.stdAuxiliary > 2.0 * step.stdAllBranches ? "attention" : "body");
    }
    suggestion_->setText(advice.suggestion.isEmpty()
                             ? tr("A suggestion requires vessels, a camera and a pose.")
                             : tr("Suggested: %1 (nearly as informative as the whole tree).").arg(advice.suggestion));
    apply_->setEnabled(!advice.suggestion.isEmpty());
    preview_->setText(advice.preview);
    method_->setText(tr("Use %1 instead").arg(advice.otherMethod));
    method_->setVisible(!advice.otherMethod.isEmpty());
    const auto enable = [](QPushButton* selector, NumberField* field, bool isPossible, const QString& whyNot) {
        selector->setEnabled(isPossible);
        field->setEnabled(isPossible);
        field->setToolTip(isPossible ? QString() : whyNot);
    };
    enable(byGeneration_, generation_, advice.generations > 0, tr("This tree has no generation data."));
    enable(byRadius_, radius_, advice.maxRadiusMm.has_value(), tr("This tree has no radii."));
    layout()->activate();
    if (const int needed = layout()->totalHeightForWidth(width()); needed > height()) {
        resize(width(), needed);   // size hints omit the height of wrapped labels
    }
}

}   // namespace angiopose::ui
