#include "ui/panels/geometry_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

namespace angiopose::ui {
namespace {

QString originText(core::Origin origin)
{
    switch (origin) {
        case core::Origin::Header:
            return GeometryPanel::tr("header");
        case core::Origin::Derived:
            return GeometryPanel::tr("derived");
        case core::Origin::User:
            return GeometryPanel::tr("entered");
        case core::Origin::Assumed:
            return GeometryPanel::tr("assumed");
        case core::Origin::Missing:
            break;
    }
    return GeometryPanel::tr("missing");
}

/// Returns whether the user should check a required value: missing, assumed, or a spacing derived from the header.
bool needsAttention(GeometryValue value, core::Origin origin)
{
    const bool isRequired = infoOf(value).isRequired;
    return isRequired && (origin == core::Origin::Missing || origin == core::Origin::Assumed ||
                          (origin == core::Origin::Derived && value == GeometryValue::Spacing));
}

std::array<GeometryValue, geometryValueCount> allValues()
{
    std::array<GeometryValue, geometryValueCount> values{};
    for (std::size_t i = 0; i < geometryValueCount; ++i) {
        values[i] = static_cast<GeometryValue>(i);
    }
    return values;
}

}   // namespace

GeometryPanel::GeometryPanel(QWidget* parent)
    : Section(
          "geometry", [] { return tr("Geometry"); }, Folding::Foldable, parent),
      displaySide_(new QComboBox),
      displaySideOrigin_(roleLabel("hint")),
      advanced_(new Section(
          "geometry/seldom", [] { return tr("Roll, principal point, isocenter"); }, Folding::Foldable)),
      header_(new Section(
          "geometry/header", [] { return tr("DICOM header values"); }, Folding::Foldable)),
      headerText_(roleLabel("hint")),
      camera_(roleLabel("label")),
      notes_(roleLabel("attentionBox")),
      assume_(withText(new QPushButton, [] { return tr("Use typical values"); })),
      removeOverride_(withText(new QPushButton, [] { return tr("Use distances and spacing instead"); }))
{
    auto* typical = makeGrid();
    auto* seldom = makeGrid();
    for (const GeometryValue value : allValues()) {
        addRow(value, value < firstAdvancedValue ? typical : seldom);
    }
    addDisplaySide(seldom);
    for (QLabel* label : {camera_, notes_, headerText_}) {
        label->setWordWrap(true);
    }
    headerText_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    for (QPushButton* button : {assume_, removeOverride_}) {
        button->setProperty("role", "quiet");
    }
    withToolTip(assume_, [] {
        return tr("Fills in missing values only: SID 1000 mm, SOD 750 mm, pixel spacing 0.3 mm, angles 0°.");
    });
    connect(assume_, &QPushButton::clicked, this, &GeometryPanel::assumeMissing);
    connect(removeOverride_, &QPushButton::clicked, this, &GeometryPanel::cameraOverrideRemoved);

    advanced_->contentLayout()->addLayout(seldom);
    header_->contentLayout()->addWidget(headerText_);
    for (Section* part : {advanced_, header_}) {
        part->layout()->setContentsMargins(0, 4, 0, 0);
        part->setFolded(true);
    }
    contentLayout()->addLayout(typical);
    contentLayout()->addWidget(camera_);
    contentLayout()->addWidget(removeOverride_);
    contentLayout()->addWidget(notes_);
    contentLayout()->addWidget(assume_);
    contentLayout()->addWidget(advanced_);
    contentLayout()->addWidget(header_);
    setFolded(true);
    showGeometry({});
}

QGridLayout* GeometryPanel::makeGrid()
{
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnMinimumWidth(0, 84);
    grid->setColumnStretch(1, 1);
    grid->setColumnMinimumWidth(2, 54);
    return grid;
}

void GeometryPanel::addRow(GeometryValue value, QGridLayout* grid)
{
    const GeometryValueInfo& kind = infoOf(value);
    auto* label = withText(roleLabel("label"), [&kind] { return tr(kind.label); });
    Row& newRow = row(value);
    newRow = {new NumberField(kind.format), roleLabel("hint")};
    withAccessibleName(newRow.field, [&kind] { return tr(kind.help); });
    keepTranslated(newRow.field, [field = newRow.field] { field->setPlaceholderText(tr("enter value")); });
    for (QWidget* widget : {static_cast<QWidget*>(label), static_cast<QWidget*>(newRow.field)}) {
        withToolTip(widget, [&kind] { return tr(kind.help); });
    }
    label->setBuddy(newRow.field);
    connect(newRow.field, &NumberField::edited, this, [this, value](double number) { editValue(value, number); });
    connect(newRow.field, &QLineEdit::returnPressed, this, [this, value] { confirmValue(value); });
    const int line = grid->rowCount();
    grid->addWidget(label, line, 0);
    grid->addWidget(newRow.field, line, 1);
    grid->addWidget(newRow.origin, line, 2);
}

void GeometryPanel::addDisplaySide(QGridLayout* grid)
{
    keepTranslated(displaySide_, [this] { setItemTexts(*displaySide_, {tr("from the detector"), tr("mirrored")}); });
    withAccessibleName(displaySide_, [] { return tr("Viewing side of the image"); });
    withToolTip(displaySide_, [] {
        return tr(
            "Angiograms are normally shown as seen from the detector. In a mirrored export, left and right are "
            "swapped; the projection is then mirrored together with the image, but the vessels themselves never are.");
    });
    connect(displaySide_, &QComboBox::activated, this, [this](int index) {
        core::CArm cArm = state_.cArm;
        cArm.mirrored = {index == 1, core::Origin::User, "chosen in the window"};
        emit edited(cArm, [] { return tr("viewing side"); });
    });
    const int line = grid->rowCount();
    grid->addWidget(withText(roleLabel("label"), [] { return tr("image"); }), line, 0);
    grid->addWidget(displaySide_, line, 1);
    grid->addWidget(displaySideOrigin_, line, 2);
}

void GeometryPanel::showGeometry(const GeometryState& state)
{
    state_ = state;
    for (const GeometryValue value : allValues()) {
        showRow(value);
    }
    showDisplaySide();
    showHeader();
    const auto& camera = state.cameraOverride;
    camera_->setVisible(camera.has_value());
    removeOverride_->setVisible(camera.has_value() && core::cameraFromCArm(state.cArm, camera->width, camera->height));
    if (camera) {
        const QString side = camera->fx < 0.0 ? tr("seen from the detector") : tr("mirrored");
        camera_->setText(tr("Camera from the case file: f %1 px, principal point %2, %3 px, %4.")
                             .arg(numberText(std::abs(camera->fx), 1))
                             .arg(numberText(camera->cx, 1))
                             .arg(numberText(camera->cy, 1))
                             .arg(side));
    }
    showNotes();
    setHint(summary());
    const bool complete = state.missing.isEmpty();
    if (!complete && wasComplete_) {
        setFolded(false);
    }
    wasComplete_ = complete;
}

void GeometryPanel::showRow(GeometryValue value)
{
    const core::SourcedValue<double> sourced = shownValue(state_, value);
    const core::Origin origin = sourced.value ? sourced.origin : core::Origin::Missing;
    const bool isFromHeader = value == GeometryValue::Sod && state_.cArm.sourceToObjectMm.value;   // no check needed
    const bool needsCheck = needsAttention(value, origin) && !isFromHeader;
    row(value).field->showValue(sourced.value);
    row(value).field->setHighlighted(needsCheck && state_.imageSizePx.x() > 0 && !state_.cameraOverride);
    row(value).origin->setText(sourced.value || infoOf(value).isRequired ? originText(origin) : QString());
    row(value).origin->setToolTip(QString::fromStdString(sourced.basis));
    setRole(row(value).origin, needsCheck ? "attention" : "hint");
}

void GeometryPanel::showDisplaySide()
{
    const auto& mirrored = state_.cArm.mirrored;
    displaySide_->setCurrentIndex(mirrored.value.value_or(false) ? 1 : 0);
    displaySideOrigin_->setText(originText(mirrored.value ? mirrored.origin : core::Origin::Assumed));
    displaySideOrigin_->setToolTip(QString::fromStdString(mirrored.basis));
}

void GeometryPanel::showHeader()
{
    QStringList lines;
    for (const core::HeaderTag& tag : state_.headerTags) {
        lines << QStringLiteral("%1 %2: %3")
                     .arg(QString::fromStdString(tag.tag), QString::fromStdString(tag.name),
                          QString::fromStdString(tag.value));
    }
    headerText_->setText(lines.join(QLatin1Char('\n')));
    header_->setVisible(!lines.isEmpty());
    header_->setHint(tr("%1 tags").arg(lines.size()));
}

void GeometryPanel::showNotes()
{
    QStringList notes;
    if (!state_.missing.isEmpty()) {
        notes << state_.missing;
    }
    for (const core::Message& contradiction : state_.contradictions) {
        notes << messageText(contradiction);
    }
    if (state_.cArm.columnSpacingMm.origin == core::Origin::Derived && !state_.cameraOverride) {
        notes << tr(
            "The header contains no pixel spacing; this value is derived. Press Enter in the field to confirm the "
            "value, or enter another one.");
    }
    if (state_.cArm.mirrored.value.value_or(false) && !state_.cameraOverride) {
        notes << tr("The image is assumed to be mirrored (%1). Check left and right.")
                     .arg(originText(state_.cArm.mirrored.origin));
    }
    if (state_.gantryRotationDeg.norm() > 0.0) {
        notes << tr("The gantry rotates during this run: by %1° in LAO/RAO and %2° in CRA/CAU from the first frame to "
                    "this one.")
                     .arg(numberText(state_.gantryRotationDeg.x(), 1))
                     .arg(numberText(state_.gantryRotationDeg.y(), 1));
    }
    notes_->setText(notes.join(QLatin1Char('\n')));
    notes_->setVisible(!notes.isEmpty());
    assume_->setVisible(!state_.missing.isEmpty());
}

QString GeometryPanel::summary() const
{
    if (!state_.missing.isEmpty()) {
        return tr("incomplete");
    }
    const core::CArm& cArm = state_.cArm;
    QStringList parts;
    if (cArm.sourceToDetectorMm.value) {
        parts << tr("SID %1").arg(numberText(*cArm.sourceToDetectorMm.value, 0));
    }
    if (const auto& depth = vesselDepthOf(cArm).value; cArm.sourceToDetectorMm.value && depth) {
        parts << QStringLiteral("× %1").arg(numberText(*cArm.sourceToDetectorMm.value / *depth, 2));
    }
    if (state_.vesselMmPerPx) {
        parts << tr("%1 mm/px").arg(numberText(*state_.vesselMmPerPx, 3));
    }
    return parts.join(QStringLiteral(" · "));
}

void GeometryPanel::focusFirstMissing()
{
    setFolded(false);
    for (const GeometryValue value : allValues()) {
        if (infoOf(value).isRequired && !shownValue(state_, value).value) {
            row(value).field->setFocus(Qt::OtherFocusReason);
            return;
        }
    }
    rows_.front().field->setFocus(Qt::OtherFocusReason);
}

void GeometryPanel::editValue(GeometryValue value, double number)
{
    emit edited(withValue(state_, value, number, core::Origin::User, "entered in the window"),
                [value] { return tr(infoOf(value).label); });
}

void GeometryPanel::confirmValue(GeometryValue value)
{
    const core::SourcedValue<double> sourced = shownValue(state_, value);
    if (sourced.value && needsAttention(value, sourced.origin)) {
        emit edited(withValue(state_, value, *sourced.value, core::Origin::User, "confirmed: " + sourced.basis),
                    [value] { return tr(infoOf(value).label); });
    }
}

void GeometryPanel::assumeMissing()
{
    GeometryState assumed = state_;
    for (const GeometryValue value : allValues()) {
        if (infoOf(value).isRequired && !shownValue(state_, value).value) {
            assumed.cArm =
                withValue(assumed, value, infoOf(value).typical, core::Origin::Assumed, "typical for a C-arm");
        }
    }
    emit edited(assumed.cArm, [] { return tr("missing values"); });
}

}   // namespace angiopose::ui
