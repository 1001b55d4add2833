#include "app/review/brightness_memory.h"

#include "app/preferences/settings.h"
#include "ui/views/angiogram_view.h"

#include <QCryptographicHash>

namespace angiopose::app {
namespace {

using namespace std::chrono_literals;

constexpr qsizetype keptSeries = 200;

/// A series without telling whose it is: settings are no place for identities.
QString seriesKey(const core::Case& current)
{
    if (!current.shown().angiogram) {
        return {};
    }
    const std::string& uid = current.shown().angiogram->identity.seriesUid;
    const std::string& known = uid.empty() ? current.shown().imageFile.sha256 : uid;
    const QByteArray text(known.data(), static_cast<qsizetype>(known.size()));
    return known.empty() ? QString()
                         : QString::fromLatin1(QCryptographicHash::hash(text, QCryptographicHash::Sha1).toHex());
}

}   // namespace

BrightnessMemory::BrightnessMemory(const CaseDocument& document, ui::AngiogramView& view, QObject* parent)
    : QObject(parent), document_(document), view_(view), remembered_(settings::brightness.read())
{
    storing_.setSingleShot(true);
    storing_.setInterval(2s);
    connect(&storing_, &QTimer::timeout, this, [this] { settings::brightness.write(remembered_); });
    connect(&document_, &CaseDocument::changed, this, &BrightnessMemory::followDocument);
    connect(&view_, &ui::AngiogramView::windowLevelChanged, this, &BrightnessMemory::remember);
}

BrightnessMemory::~BrightnessMemory()
{
    if (storing_.isActive()) {
        settings::brightness.write(remembered_);
    }
}

void BrightnessMemory::followDocument()
{
    if (document_.current().shown().angiogram != shown_) {
        shown_ = document_.current().shown().angiogram;
        series_.clear();   // what the view does by itself on a new image is not the user's choice
        QMetaObject::invokeMethod(this, &BrightnessMemory::recall, Qt::QueuedConnection);   // once the image is shown
    }
}

void BrightnessMemory::recall()
{
    const QString series = seriesKey(document_.current());
    bool isKnown = false;
    for (const QString& line : std::as_const(remembered_)) {
        const QStringList parts = line.split(QLatin1Char(' '));
        if (parts.size() == 3 && parts[0] == series) {
            isKnown = true;
            view_.setWindowLevel(parts[1].toDouble(), parts[2].toDouble());
            break;
        }
    }
    if (!isKnown && shown_) {
        view_.autoWindowLevel();
    }
    series_ = series;
}

void BrightnessMemory::remember(double window, double level)
{
    if (series_.isEmpty()) {
        return;
    }
    const QString prefix = series_ + QLatin1Char(' ');
    remembered_.removeIf([&prefix](const QString& line) { return line.startsWith(prefix); });
    remembered_.prepend(prefix + QString::number(window, 'g', 9) + QLatin1Char(' ') + QString::number(level, 'g', 9));
    remembered_ = remembered_.first(std::min(remembered_.size(), keptSeries));
    storing_.start();
}

}   // namespace angiopose::app