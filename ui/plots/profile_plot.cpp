#include "ui/plots/profile_plot.h"

#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr int profileLabelHeight = 18;
constexpr double minAxisCurvature =
    0.02;   // 1/mm: minimum range of the curvature axis, to keep noise from looking like curvature

double diameterIn(const core::ProfileSample& sample)
{
    return sample.diameterMm;
}

double referenceIn(const core::ProfileSample& sample)
{
    return sample.referenceDiameterMm;
}

double deformationIn(const core::ProfileSample& sample)
{
    return sample.curvaturePerMm;
}

double maximumOf(const core::BranchProfile& profile, double (*value)(const core::ProfileSample&), double least)
{
    double maximum = least;
    for (const core::ProfileSample& sample : profile.samples) {
        maximum = std::fmax(maximum, value(sample));   // fmax ignores NaN
    }
    return maximum;
}

}   // namespace

ProfilePlot::ProfilePlot(QWidget* parent) : QWidget(parent)
{
    setMinimumHeight(118);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    withAccessibleName(this, [] { return tr("Diameter and curvature along the branch"); });
}

void ProfilePlot::showProfile(const core::BranchProfile& profile)
{
    profile_ = profile;
    hoveredIndex_.reset();
    maxMm_ = std::fmax(maximumOf(profile_, diameterIn, 0.0),
                       profile_.stenosis ? maximumOf(profile_, referenceIn, 0.0) : 0.0);
    maxCurvature_ = maximumOf(profile_, deformationIn, minAxisCurvature);
    update();
}

QRectF ProfilePlot::area() const
{
    return QRectF(rect()).adjusted(4, profileLabelHeight, -4, -profileLabelHeight);
}

QPointF ProfilePlot::positionOf(const core::ProfileSample& sample, double fraction) const
{
    const QRectF plot = area();
    return {plot.left() + plot.width() * sample.arcLengthMm / profile_.lengthMm,
            plot.bottom() - fraction * plot.height()};
}

std::size_t ProfilePlot::indexAt(double x) const
{
    const double fraction = std::clamp((x - area().left()) / std::max(1.0, area().width()), 0.0, 1.0);
    return static_cast<std::size_t>(std::lround(fraction * static_cast<double>(profile_.samples.size() - 1)));
}

void ProfilePlot::paintCurve(QPainter& painter, Value value, double maximum, const QPen& pen) const
{
    QPolygonF line;
    for (const core::ProfileSample& sample : profile_.samples) {
        if (std::isfinite(value(sample))) {
            line << positionOf(sample, value(sample) / maximum);
        }
    }
    painter.setPen(pen);
    painter.drawPolyline(line);
}

void ProfilePlot::paintLabels(QPainter& painter) const
{
    const Palette& colors = activePalette();
    const QRectF plot = area();
    const QRectF above(plot.left(), 0.0, plot.width(), profileLabelHeight);
    const QRectF below(plot.left(), plot.bottom() + 2.0, plot.width(), profileLabelHeight - 2);
    painter.setPen(toQColor(colors.accent));
    if (maxMm_ > 0.0) {
        painter.drawText(above, Qt::AlignLeft | Qt::AlignVCenter, tr("⌀ %1 mm").arg(numberText(maxMm_, 1)));
    }
    painter.setPen(toQColor(colors.label));
    painter.drawText(above, Qt::AlignRight | Qt::AlignVCenter, tr("curvature %1/mm").arg(numberText(maxCurvature_, 2)));
    painter.setPen(toQColor(colors.hint));
    painter.drawText(below, Qt::AlignLeft | Qt::AlignTop, QStringLiteral("0"));
    painter.drawText(below, Qt::AlignRight | Qt::AlignTop, tr("%1 mm").arg(numberText(profile_.lengthMm, 0)));
}

void ProfilePlot::paintEvent(QPaintEvent*)
{
    const Palette& colors = activePalette();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF plot = area();
    painter.setPen(toQColor(colors.line));
    painter.drawLine(plot.bottomLeft(), plot.bottomRight());
    if (profile_.samples.size() < 2) {
        return;
    }
    paintCurve(painter, deformationIn, maxCurvature_, QPen(toQColor(colors.hint), 1.0));
    if (maxMm_ > 0.0) {
        paintCurve(painter, referenceIn, maxMm_, QPen(toQColor(colors.label), 1.2, Qt::DashLine));
        paintCurve(painter, diameterIn, maxMm_, QPen(toQColor(colors.accent), 1.6));
    }
    if (profile_.stenosis) {
        core::ProfileSample narrowest;
        narrowest.arcLengthMm = profile_.stenosis->positionMm;
        painter.setPen(Qt::NoPen);
        painter.setBrush(toQColor(colors.attention));
        painter.drawEllipse(positionOf(narrowest, profile_.stenosis->diameterMm / maxMm_), 3.2, 3.2);
    }
    if (hoveredIndex_) {
        const double x = positionOf(profile_.samples[*hoveredIndex_], 0.0).x();
        painter.setPen(toQColor(colors.text));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    }
    paintLabels(painter);
    if (hasFocus()) {
        painter.setPen(toQColor(colors.accent));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

QString ProfilePlot::textAt(std::size_t index) const
{
    const core::ProfileSample& sample = profile_.samples[index];
    QStringList parts{tr("at %1 mm").arg(numberText(sample.arcLengthMm, 1))};
    if (std::isfinite(sample.diameterMm)) {
        parts << tr("⌀ %1 mm").arg(numberText(sample.diameterMm, 2));
    }
    if (std::isfinite(sample.referenceDiameterMm)) {
        parts << tr("reference %1 mm").arg(numberText(sample.referenceDiameterMm, 2));
    }
    if (std::isfinite(sample.curvaturePerMm)) {
        parts << tr("curvature %1/mm").arg(numberText(sample.curvaturePerMm, 3));
    }
    return parts.join(QStringLiteral(" · "));
}

void ProfilePlot::point(std::size_t index)
{
    if (hoveredIndex_ != index) {
        hoveredIndex_ = index;
        update();
        emit pointerMoved(profile_.samples[index].pointInPatient);
    }
}

void ProfilePlot::mouseMoveEvent(QMouseEvent* event)
{
    if (profile_.samples.size() > 1) {
        const std::size_t index = indexAt(event->position().x());
        point(index);
        QToolTip::showText(event->globalPosition().toPoint(), textAt(index), this);
    }
}

void ProfilePlot::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && profile_.samples.size() > 1) {
        point(indexAt(event->position().x()));
        emit positionClicked(profile_.samples[*hoveredIndex_].pointInPatient);
    }
}

void ProfilePlot::leaveEvent(QEvent*)
{
    if (hoveredIndex_) {
        hoveredIndex_.reset();
        update();
        emit pointerMoved(std::nullopt);
    }
}

void ProfilePlot::keyPressEvent(QKeyEvent* event)
{
    const bool isStep = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (profile_.samples.size() < 2 || !(isStep || (isEnter && hoveredIndex_))) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (isEnter) {
        emit positionClicked(profile_.samples[*hoveredIndex_].pointInPatient);
        return;
    }
    const std::size_t last = profile_.samples.size() - 1;
    const std::size_t from = hoveredIndex_.value_or(0);
    point(event->key() == Qt::Key_Right ? std::min(from + 1, last) : from - (from > 0 ? 1 : 0));
}

}   // namespace angiopose::ui
