#include "ui/panels/geometry_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/spoken.h"

namespace angiopose::ui {
namespace {

QString originWord(core::Origin origin)
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

/// True for required values the user should check: missing, assumed, or a spacing derived from the header.
bool needsLook(GeometryValue value, core::Origin origin)
{
    const bool isNeeded = kindOf(value).isNeeded;
    return isNeeded && (origin == core::Origin::Missing || origin == core::Origin::Assumed ||
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
      shownFrom_(new QComboBox),
      shownFromOrigin_(roleLabel("hint")),
      seldom_(new Section(
          "geometry/seldom", [] { return tr("Roll, principal point, isocenter"); }, Folding::Foldable)),
      header_(new Section(
          "geometry/header", [] { return tr("DICOM header values"); }, Folding::Foldable)),
      headerText_(roleLabel("hint")),
      camera_(roleLabel("label")),
      notes_(roleLabel("attentionBox")),
      assume_(withText(new QPushButton, [] { return tr("Use typical values"); })),
      dropOverride_(withText(new QPushButton, [] { return tr("Use distances and spacing instead"); }))
{
    auto* usual = makeGrid();
    auto* seldom = makeGrid();
    for (const GeometryValue value : allValues()) {
        addRow(value, value < firstSeldomValue ? usual : seldom);
    }
    addShownFrom(seldom);
    for (QLabel* label : {camera_, notes_, headerText_}) {
        label->setWordWrap(true);
    }
    headerText_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    for (QPushButton* button : {assume_, dropOverride_}) {
        button->setProperty("role", "quiet");
    }
    withTip(assume_,
            [] { return tr("SID 1000 mm, SOD 750 mm, pixel 0.3 mm, angles 0°: fills in missing values only."); });
    connect(assume_, &QPushButton::clicked, this, &GeometryPanel::assumeMissing);
    connect(dropOverride_, &QPushButton::clicked, this, &GeometryPanel::cameraOverrideDropped);

    seldom_->contentLayout()->addLayout(seldom);
    header_->contentLayout()->addWidget(headerText_);
    for (Section* part : {seldom_, header_}) {
        part->layout()->setContentsMargins(0, 4, 0, 0);
        part->setFolded(true);
    }
    contentLayout()->addLayout(usual);
    contentLayout()->addWidget(camera_);
    contentLayout()->addWidget(dropOverride_);
    contentLayout()->addWidget(notes_);
    contentLayout()->addWidget(assume_);
    contentLayout()->addWidget(seldom_);
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
    const GeometryValueKind& kind = kindOf(value);
    auto* label = withText(roleLabel("label"), [&kind] { return tr(kind.label); });
    Row& made = row(value);
    made = {new NumberField(kind.format), roleLabel("hint")};
    withName(made.field, [&kind] { return tr(kind.help); });
    speak(made.field, [field = made.field] { field->setPlaceholderText(tr("enter value")); });
    for (QWidget* widget : {static_cast<QWidget*>(label), static_cast<QWidget*>(made.field)}) {
        withTip(widget, [&kind] { return tr(kind.help); });
    }
    label->setBuddy(made.field);
    connect(made.field, &NumberField::edited, this, [this, value](double number) { editValue(value, number); });
    connect(made.field, &QLineEdit::returnPressed, this, [this, value] { confirmValue(value); });
    const int line = grid->rowCount();
    grid->addWidget(label, line, 0);
    grid->addWidget(made.field, line, 1);
    grid->addWidget(made.origin, line, 2);
}

void GeometryPanel::addShownFrom(QGridLayout* grid)
{
    speak(shownFrom_, [this] { setWords(*shownFrom_, {tr("from the detector"), tr("mirrored")}); });
    withName(shownFrom_, [] { return tr("Viewing side of the image"); });
    withTip(shownFrom_, [] {
        return tr(
            "Angiograms are shown as seen from the detector. A mirrored export swaps left and right: the projection is "
            "mirrored with the image, the vessels never are.");
    });
    connect(shownFrom_, &QComboBox::activated, this, [this](int index) {
        core::CArm cArm = state_.cArm;
        cArm.mirrored = {index == 1, core::Origin::User, "chosen in the window"};
        emit edited(cArm, [] { return tr("viewing side"); });
    });
    const int line = grid->rowCount();
    grid->addWidget(withText(roleLabel("label"), [] { return tr("image"); }), line, 0);
    grid->addWidget(shownFrom_, line, 1);
    grid->addWidget(shownFromOrigin_, line, 2);
}

void GeometryPanel::showGeometry(const GeometryState& state)
{
    state_ = state;
    for (const GeometryValue value : allValues()) {
        showRow(value);
    }
    showShownFrom();
    showHeader();
    const auto& camera = state.cameraOverride;
    camera_->setVisible(camera.has_value());
    dropOverride_->setVisible(camera.has_value() && core::cameraFromCArm(state.cArm, camera->width, camera->height));
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
    const core::Sourced<double> sourced = shownValue(state_, value);
    const core::Origin origin = sourced.value ? sourced.origin : core::Origin::Missing;
    const bool isOfHeader = value == GeometryValue::Sod && state_.cArm.sourceToObjectMm.value;   // no check needed
    const bool isLooked = needsLook(value, origin) && !isOfHeader;
    row(value).field->showValue(sourced.value);
    row(value).field->setAsking(isLooked && state_.imageSizePx.x() > 0 && !state_.cameraOverride);
    row(value).origin->setText(sourced.value || kindOf(value).isNeeded ? originWord(origin) : QString());
    row(value).origin->setToolTip(QString::fromStdString(sourced.basis));
    setRole(row(value).origin, isLooked ? "attention" : "hint");
}

void GeometryPanel::showShownFrom()
{
    const auto& mirrored = state_.cArm.mirrored;
    shownFrom_->setCurrentIndex(mirrored.value.value_or(false) ? 1 : 0);
    shownFromOrigin_->setText(originWord(mirrored.value ? mirrored.origin : core::Origin::Assumed));
    shownFromOrigin_->setToolTip(QString::fromStdString(mirrored.basis));
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
            "The header gives no pixel spacing; this value is derived. Press Enter in the field to confirm it, or "
            "enter another value.");
    }
    if (state_.cArm.mirrored.value.value_or(false) && !state_.cameraOverride) {
        notes << tr("The image is assumed to be mirrored (%1). Check left and right.")
                     .arg(originWord(state_.cArm.mirrored.origin));
    }
    if (state_.turnedDeg.norm() > 0.0) {
        notes << tr("The gantry rotates during this run: by %1° LAO/RAO and %2° CRA/CAU from the first frame to this "
                    "one.")
                     .arg(numberText(state_.turnedDeg.x(), 1))
                     .arg(numberText(state_.turnedDeg.y(), 1));
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
        if (kindOf(value).isNeeded && !shownValue(state_, value).value) {
            row(value).field->setFocus(Qt::OtherFocusReason);
            return;
        }
    }
    rows_.front().field->setFocus(Qt::OtherFocusReason);
}

void GeometryPanel::editValue(GeometryValue value, double number)
{
    emit edited(withValue(state_, value, number, core::Origin::User, "entered in the window"),
                [value] { return tr(kindOf(value).label); });
}

void GeometryPanel::confirmValue(GeometryValue value)
{
    const core::Sourced<double> sourced = shownValue(state_, value);
    if (sourced.value && needsLook(value, sourced.origin)) {
        emit edited(withValue(state_, value, *sourced.value, core::Origin::User, "confirmed: " + sourced.basis),
                    [value] { return tr(kindOf(value).label); });
    }
}

void GeometryPanel::assumeMissing()
{
    GeometryState assumed = state_;
    for (const GeometryValue value : allValues()) {
        if (kindOf(value).isNeeded && !shownValue(state_, value).value) {
            assumed.cArm = withValue(assumed, value, kindOf(value).usual, core::Origin::Assumed, "typical for a C-arm");
        }
    }
    emit edited(assumed.cArm, [] { return tr("missing values"); });
}

}   // namespace angiopose::ui
