#include "ui/panels/option_form.h"

#include "ui/panels/number_field.h"
#include "ui/panels/section.h"
#include "ui/words/spoken.h"
#include "ui/words/terms.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

QString fromView(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// "largest_squared" is a key of the case file; people read "largest squared".
QString choiceText(std::string_view key)
{
    return termText(fromView(key).replace(QLatin1Char('_'), QLatin1Char(' ')));
}

bool appliesTo(const core::OptionField& field, const std::string& method)
{
    return field.methods.empty() || std::ranges::find(field.methods, method) != field.methods.end();
}

bool isSwitch(const core::OptionField& field)
{
    return field.choices.empty() && field.decimals == 0 && field.min == 0.0 && field.max == 1.0;
}

/// A step that feels right for the size of the range: 1, 0.1, …, never below the last shown digit.
double stepOf(const core::OptionField& field)
{
    return std::max(std::pow(10.0, -field.decimals), std::min(1.0, std::pow(10.0, 1 - field.decimals)));
}

}   // namespace

OptionForm::OptionForm(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this))
{
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setHorizontalSpacing(10);
    form_->setVerticalSpacing(6);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form_->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    rebuild();
}

void OptionForm::showOptions(const core::RegistrationOptions& options)
{
    options_ = options;
    if (options.method != shownMethod_) {
        rebuild();
    }
    for (const auto& refresh : refreshers_) {
        refresh();
    }
}

void OptionForm::rebuild()
{
    shownMethod_ = options_.method;
    refreshers_.clear();
    while (form_->rowCount() > 0) {
        form_->removeRow(0);
    }
    for (const core::OptionField& field : core::optionFields()) {
        if (!appliesTo(field, shownMethod_)) {
            continue;
        }
        QWidget* editor = makeEditor(field);
        editor->setObjectName(fromView(field.key));
        withName(editor, [&field] { return termText(field.label); });
        withTip(editor, [&field] { return termText(field.help); });
        auto* label = withText(roleLabel("label"), [&field] { return termText(field.label); });
        withTip(label, [&field] { return termText(field.help); });
        form_->addRow(label, editor);
        refreshers_.back()();
    }
}

QWidget* OptionForm::makeEditor(const core::OptionField& field)
{
    if (!field.choices.empty()) {
        auto* box = new QComboBox;
        speak(box, [box, &field] {
            QStringList words;
            for (const std::string_view choice : field.choices) {
                words << choiceText(choice);
            }
            setWords(*box, words);
        });
        connect(box, &QComboBox::activated, this, [this, &field](int index) { write(field, index); });
        refreshers_.emplace_back([this, &field, box] { box->setCurrentIndex(static_cast<int>(field.read(options_))); });
        return box;
    }
    if (isSwitch(field)) {
        auto* box = new QCheckBox;
        connect(box, &QCheckBox::clicked, this, [this, &field](bool on) { write(field, on ? 1.0 : 0.0); });
        refreshers_.emplace_back([this, &field, box] { box->setChecked(field.read(options_) > 0.5); });
        return box;
    }
    auto* box = new NumberField({field.min, field.max, field.decimals, fromView(field.unit), stepOf(field)});
    connect(box, &NumberField::edited, this, [this, &field](double value) { write(field, value); });
    refreshers_.emplace_back([this, &field, box] { box->showValue(field.read(options_)); });
    return box;
}

void OptionForm::write(const core::OptionField& field, double value)
{
    field.write(options_, value);
    emit edited(options_, [&field] { return termText(field.label); });   // the table of options stays
}

}   // namespace angiopose::ui