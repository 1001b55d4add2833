#include "ui/panels/geometry_panel.h"

#include "ui/words/core_texts.h"

#include <QGridLayout>

namespace ui {
namespace {

/// How each value is shown, and what to assume when nobody knows it: a usual C-arm.
struct ValueKind {
    const char* label;
    const char* help;
    NumberFormat format;
    double usual;
};

const ValueKind& kindOf(int value)
{
    static const std::array<ValueKind, 5> kinds{
        {{QT_TRANSLATE_NOOP("ui::GeometryPanel", "SID"),
          QT_TRANSLATE_NOOP("ui::GeometryPanel", "Source to detector distance"),
          {100.0, 3000.0, 1, QStringLiteral("mm"), 1.0},
          1000.0},
         {QT_TRANSLATE_NOOP("ui::GeometryPanel", "SOD"),
          QT_TRANSLATE_NOOP("ui::GeometryPanel", "Source to isocentre distance"),
          {100.0, 3000.0, 1, QStringLiteral("mm"), 1.0},
          750.0},
         {QT_TRANSLATE_NOOP("ui::GeometryPanel", "pixel"),
          QT_TRANSLATE_NOOP("ui::GeometryPanel", "Pixel pitch on the detector"),
          {0.01, 5.0, 4, QStringLiteral("mm"), 0.01},
          0.3},
         {QT_TRANSLATE_NOOP("ui::GeometryPanel", "LAO / RAO"),
          QT_TRANSLATE_NOOP("ui::GeometryPanel", "Primary angle: LAO positive, RAO negative"),
          {-180.0, 180.0, 1, QStringLiteral("°"), 1.0, NumberSign::Always},
          0.0},
         {QT_TRANSLATE_NOOP("ui::GeometryPanel", "CRA / CAU"),
          QT_TRANSLATE_NOOP("ui::GeometryPanel", "Secondary angle: CRA positive, CAU negative"),
          {-90.0, 90.0, 1, QStringLiteral("°"), 1.0, NumberSign::Always},
          0.0}}};
    return kinds[static_cast<std::size_t>(value)];
}

QString originWord(core::Origin origin)
{
    switch (origin) {
        case core::Origin::Header:
            return GeometryPanel::tr("header");
        case core::Origin::Derived:
            return GeometryPanel::tr("derived");
        case core::Origin::User:
            return GeometryPanel::tr("typed");
        case core::Origin::Assumed:
            return GeometryPanel::tr("assumed");
        case core::Origin::Missing:
            break;
    }
    return GeometryPanel::tr("missing");
}

bool needsLook(core::Origin origin)
{
    return origin == core::Origin::Missing || origin == core::Origin::Assumed;
}

}   // namespace

GeometryPanel::GeometryPanel(QWidget* parent)
    : Section(tr("Geometry"), Folding::Foldable, parent),
      camera_(roleLabel("label")),
      notes_(roleLabel("attentionBox")),
      assume_(new QPushButton(tr("Assume usual values"))),
      dropOverride_(new QPushButton(tr("Use distances and spacing instead")))
{
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnMinimumWidth(0, 84);
    grid->setColumnStretch(1, 1);
    for (int i = 0; i < ValueCount; ++i) {
        rows_[static_cast<std::size_t>(i)] = makeRow(static_cast<Value>(i));
        auto* label = roleLabel("label", tr(kindOf(i).label));
        label->setToolTip(tr(kindOf(i).help));
        grid->addWidget(label, i, 0);
        grid->addWidget(rows_[static_cast<std::size_t>(i)].field, i, 1);
        grid->addWidget(rows_[static_cast<std::size_t>(i)].origin, i, 2);
    }
    grid->setColumnMinimumWidth(2, 54);
    camera_->setWordWrap(true);
    notes_->setWordWrap(true);
    for (QPushButton* button : {assume_, dropOverride_}) {
        button->setProperty("role", "quiet");
    }
    assume_->setToolTip(tr("SID 1000 mm, SOD 750 mm, pixel 0.3 mm, angles 0°: only for what is missing."));
    connect(assume_, &QPushButton::clicked, this, &GeometryPanel::assumeMissing);
    connect(dropOverride_, &QPushButton::clicked, this, &GeometryPanel::cameraOverrideDropped);

    contentLayout()->addLayout(grid);
    contentLayout()->addWidget(camera_);
    contentLayout()->addWidget(dropOverride_);
    contentLayout()->addWidget(notes_);
    contentLayout()->addWidget(assume_);
    setFolded(true);
    showGeometry({});
}

GeometryPanel::Row GeometryPanel::makeRow(Value value)
{
    Row row{new NumberField(kindOf(value).format), roleLabel("hint")};
    row.field->setAccessibleName(tr(kindOf(value).help));
    row.field->setToolTip(tr(kindOf(value).help));
    row.field->setPlaceholderText(tr("missing"));
    connect(row.field, &NumberField::edited, this, [this, value](double number) { editValue(value, number); });
    return row;
}

core::Sourced<double>& GeometryPanel::valueIn(core::CArm& cArm, Value value)
{
    switch (value) {
        case Sid:
            return cArm.sourceToDetectorMm;
        case Sod:
            return cArm.sourceToPatientMm;
        case Spacing:
            return cArm.columnSpacingMm;
        case Primary:
            return cArm.primaryAngleDeg;
        case Secondary:
        case ValueCount:
            break;
    }
    return cArm.secondaryAngleDeg;
}

void GeometryPanel::showGeometry(const GeometryState& state)
{
    cArm_ = state.cArm;
    for (int i = 0; i < ValueCount; ++i) {
        showRow(static_cast<Value>(i));
    }
    const auto& camera = state.cameraOverride;
    camera_->setVisible(camera.has_value());
    dropOverride_->setVisible(camera.has_value() && core::cameraFromCArm(cArm_, camera->width, camera->height));
    if (camera) {
        camera_->setText(tr("Camera from the case file: f %1 px, centre %2, %3 px, %4.")
                             .arg(std::abs(camera->fx), 0, 'f', 1)
                             .arg(camera->cx, 0, 'f', 1)
                             .arg(camera->cy, 0, 'f', 1)
                             .arg(camera->fx < 0.0 ? tr("seen from the detector") : tr("mirrored")));
    }
    showNotes(state);
    setHint(summary(state));
    const bool complete = state.missing.isEmpty();
    if (!complete && wasComplete_) {
        setFolded(false);
    }
    wasComplete_ = complete;
}

void GeometryPanel::showRow(Value value)
{
    const core::Sourced<double>& sourced = valueIn(cArm_, value);
    const Row& row = rows_[value];
    const core::Origin origin = sourced.value ? sourced.origin : core::Origin::Missing;
    row.field->showValue(sourced.value);
    row.origin->setText(originWord(origin));
    row.origin->setToolTip(coreText(sourced.basis));
    setRole(row.origin, needsLook(origin) ? "attention" : "hint");
}

void GeometryPanel::showNotes(const GeometryState& state)
{
    QStringList notes;
    if (!state.missing.isEmpty()) {
        notes << state.missing;
    }
    for (const std::string& contradiction : state.contradictions) {
        notes << coreText(contradiction);
    }
    notes_->setText(notes.join(QLatin1Char(' ')));
    notes_->setVisible(!notes.isEmpty());
    assume_->setVisible(!state.missing.isEmpty());
}

QString GeometryPanel::summary(const GeometryState& state) const
{
    if (!state.missing.isEmpty()) {
        return tr("incomplete");
    }
    QStringList parts;
    if (cArm_.sourceToDetectorMm.value) {
        parts << tr("SID %1").arg(*cArm_.sourceToDetectorMm.value, 0, 'f', 0);
    }
    if (state.vesselMmPerPx) {
        parts << tr("%1 mm/px").arg(*state.vesselMmPerPx, 0, 'f', 3);
    }
    return parts.join(QStringLiteral(" · "));
}

void GeometryPanel::focusFirstMissing()
{
    setFolded(false);
    for (int i = 0; i < ValueCount; ++i) {
        if (!valueIn(cArm_, static_cast<Value>(i)).value) {
            rows_[static_cast<std::size_t>(i)].field->setFocus(Qt::OtherFocusReason);
            return;
        }
    }
    rows_.front().field->setFocus(Qt::OtherFocusReason);
}

void GeometryPanel::editValue(Value value, double number)
{
    const core::Sourced<double> typed{number, core::Origin::User, "typed in the window"};
    valueIn(cArm_, value) = typed;
    if (value == Spacing) {
        cArm_.rowSpacingMm = typed;
    }
    emit edited(cArm_, tr(kindOf(value).label));
}

void GeometryPanel::assumeMissing()
{
    for (int i = 0; i < ValueCount; ++i) {
        auto& sourced = valueIn(cArm_, static_cast<Value>(i));
        if (!sourced.value) {
            sourced = {kindOf(i).usual, core::Origin::Assumed, "usual for a C-arm"};
            if (i == Spacing) {
                cArm_.rowSpacingMm = sourced;
            }
        }
    }
    emit edited(cArm_, tr("missing values"));
}

}   // namespace ui
