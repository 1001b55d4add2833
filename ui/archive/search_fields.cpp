#include "ui/archive/search_fields.h"

#include "ui/controls/section.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace angiopose::ui {
namespace {

/// Returns a layout with the field below its label.
QVBoxLayout* namedField(const QString& name, QWidget* field)
{
    auto* label = roleLabel("label", name);
    label->setBuddy(field);
    field->setAccessibleName(name);
    auto* column = new QVBoxLayout;
    column->setSpacing(4);
    column->addWidget(label);
    column->addWidget(field);
    return column;
}

QLineEdit* searchField(const QString& placeholder, const QString& tip)
{
    auto* field = new QLineEdit;
    field->setPlaceholderText(placeholder);
    field->setToolTip(tip);
    field->setClearButtonEnabled(true);
    return field;
}

}   // namespace

SearchFields::SearchFields(QWidget* parent)
    : QWidget(parent),
      name_(searchField(tr("Meier, or *mei*"), tr("Beginning of the name; * and ? are wildcards"))),
      id_(searchField(QString(), tr("Patient ID; * and ? are wildcards"))),
      from_(searchField(tr("2024-01-31"), tr("Studies on or after this date; leave empty for no limit"))),
      to_(searchField(tr("2024-01-31"), tr("Studies on or before this date; leave empty for today"))),
      modality_(new QComboBox),
      search_(new QPushButton(tr("Search")))
{
    modality_->addItem(tr("Any"), QString());
    for (const char* modality : {"XA", "CT", "MR", "RF", "SEG"}) {
        modality_->addItem(QLatin1String(modality), QLatin1String(modality));
    }
    modality_->setToolTip(tr("XA: angiograms, CT: scans"));
    search_->setToolTip(tr("Lists the studies that match all criteria"));
    search_->setObjectName(QStringLiteral("archiveSearch"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    layout->addLayout(namedField(tr("Patient's name"), name_), 3);
    layout->addLayout(namedField(tr("Patient ID"), id_), 2);
    layout->addLayout(namedField(tr("Study date from"), from_), 2);
    layout->addLayout(namedField(tr("to"), to_), 2);
    layout->addLayout(namedField(tr("Modality"), modality_), 1);
    layout->addWidget(search_, 0, Qt::AlignBottom);
    search_->setAutoDefault(false);
    connect(search_, &QPushButton::clicked, this, &SearchFields::request);
    for (QLineEdit* field : {name_, id_, from_, to_}) {
        connect(field, &QLineEdit::returnPressed, this, &SearchFields::request);
    }
}

void SearchFields::request()
{
    if (search_->isEnabled()) {
        emit searchRequested();
    }
}

void SearchFields::showSearch(const ArchiveSearch& search)
{
    name_->setText(search.patientName);
    id_->setText(search.patientId);
    from_->setText(search.from);
    to_->setText(search.to);
    const int index = modality_->findData(search.modality);
    modality_->setCurrentIndex(index < 0 ? 0 : index);
}

ArchiveSearch SearchFields::search() const
{
    return {name_->text().trimmed(), id_->text().trimmed(), from_->text().trimmed(), to_->text().trimmed(),
            modality_->currentData().toString()};
}

void SearchFields::setSearchEnabled(bool isEnabled)
{
    search_->setEnabled(isEnabled);
}

void SearchFields::focusFirst()
{
    name_->setFocus();
}

}   // namespace angiopose::ui
