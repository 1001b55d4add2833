#include "ui/panels/option_form.h"

#include "ui/controls/number_field.h"
#include "ui/controls/section.h"
#include "ui/words/retranslation.h"
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

/// Returns a readable text for a key of the case file, e.g. "largest squared" for "largest_squared".
QString choiceText(std::string_view key)
{
    return termText(fromView(key).replace(QLatin1Char('_'), QLatin1Char(' ')));
}

/// Returns an increment that suits the number of decimals: 1, 0.1, …, but at least one unit of the last digit shown.
double stepOf(const core::NumberOption& number)
{
    return std::max(std::pow(10.0, -number.decimals), std::min(1.0, std::pow(10.0, 1 - number.decimals)));
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
    if (options.method != displayedMethod_) {
        rebuild();
    }
    for (const auto& refresh : refreshers_) {
        refresh();
    }
}

void OptionForm::rebuild()
{
    displayedMethod_ = options_.method;
    refreshers_.clear();
    while (form_->rowCount() > 0) {
        form_->removeRow(0);
    }
    for (const core::OptionField& field : core::optionFields()) {
        if (!core::appliesTo(field, displayedMethod_)) {
            continue;
        }
        QWidget* editor = makeEditor(field);
        editor->setObjectName(fromView(field.key));
        withAccessibleName(editor, [&field] { return termText(field.label); });
        withToolTip(editor, [&field] { return termText(field.help); });
        auto* label = withText(roleLabel("label"), [&field] { return termText(field.label); });
        withToolTip(label, [&field] { return termText(field.help); });
        form_->addRow(label, editor);
        refreshers_.back()();
    }
}

QWidget* OptionForm::makeEditor(const core::OptionField& field)
{
    if (const auto* number = std::get_if<core::NumberOption>(&field.type)) {
        return makeNumber(field, *number);
    }
    return std::holds_alternative<core::SwitchOption>(field.type) ? makeSwitch(field) : makeChoice(field);
}

QWidget* OptionForm::makeSwitch(const core::OptionField& field)
{
    auto* box = new QCheckBox;
    connect(box, &QCheckBox::clicked, this, [this, &field](bool on) { write(field, on); });
    refreshers_.emplace_back([this, &field, box] { box->setChecked(std::get<bool>(field.read(options_))); });
    return box;
}

QWidget* OptionForm::makeChoice(const core::OptionField& field)
{
    auto* box = new QComboBox;
    keepTranslated(box, [box, &field] {
        QStringList words;
        for (const std::string_view name : core::namesOf(field)) {
            words << choiceText(name);
        }
        setItemTexts(*box, words);
    });
    connect(box, &QComboBox::activated, this,
            [this, &field](int index) { write(field, static_cast<std::size_t>(index)); });
    refreshers_.emplace_back(
        [this, &field, box] { box->setCurrentIndex(static_cast<int>(std::get<std::size_t>(field.read(options_)))); });
    return box;
}

QWidget* OptionForm::makeNumber(const core::OptionField& field, const core::NumberOption& number)
{
    auto* box = new NumberField({number.min, number.max, number.decimals, fromView(number.unit), stepOf(number)});
    connect(box, &NumberField::edited, this, [this, &field](double value) { write(field, value); });
    refreshers_.emplace_back([this, &field, box] { box->showValue(std::get<double>(field.read(options_))); });
    return box;
}

void OptionForm::write(const core::OptionField& field, const core::OptionValue& value)
{
    field.write(options_, value);
    emit edited(options_, [&field] { return termText(field.label); });   // `field` refers to the static option table
}

}   // namespace angiopose::ui
