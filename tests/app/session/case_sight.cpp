#include "tests/app/session/case_sight.h"

#include "app/report/case_report.h"
#include "io/case/case_file.h"
#include "io/results/result_file.h"
#include "tests/app/session/words_of_window.h"
#include "tests/app/wait_for.h"
#include "ui/views/angiogram_view.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QHoverEvent>
#include <QListView>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <utility>

namespace angiopose::test {
namespace {

QStringList linesOf(const QByteArray& text)
{
    return QString::fromUtf8(text).split(QLatin1Char('\n'));
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("not there");
}

QString digestOf(const QByteArray& bytes)
{
    return QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha1).toHex());
}

std::vector<std::pair<QString, QWidget*>> panelsOf(ui::MainWindow& window)
{
    return {
        {QStringLiteral("patient"), &window.patient()},     {QStringLiteral("branches"), &window.branches()},
        {QStringLiteral("views"), &window.views()},         {QStringLiteral("angiogram"), &window.angiogramPanel()},
        {QStringLiteral("pose"), &window.pose()},           {QStringLiteral("geometry"), &window.geometryPanel()},
        {QStringLiteral("landmarks"), &window.landmarks()}, {QStringLiteral("registration"), &window.registration()},
        {QStringLiteral("result card"), &window.result()},  {QStringLiteral("poses"), &window.snapshots()},
        {QStringLiteral("steps"), &window.steps()}};
}

/// The HTML report from which the PDF is printed, with images represented by their content and without the creation
/// time.
QStringList reportOf(app::CaseController& controller)
{
    const auto target = controller.target().current();
    if (!target) {
        return {QStringLiteral("no target")};
    }
    const auto views = app::evaluateViews(controller.document().current(), *target, {});
    const auto page = views ? app::reportBytes({views.value(), QStringLiteral("Ada"), {}, {}}, app::ReportKind::Html)
                            : core::Result<QByteArray>(views.error());
    if (!page) {
        return {QString::fromStdString(page.error().message.text())};
    }
    static const QRegularExpression made(QStringLiteral("(>Made&nbsp;&nbsp;</td><td[^>]*>)[^<]*"));
    static const QRegularExpression cells(QStringLiteral("(?=<(p|tr|td|h\\d|img)\\b)"));
    QStringList parts = QString::fromUtf8(page.value()).replace(made, QStringLiteral("\\1")).split(cells);
    for (QString& part : parts) {
        part = part.size() > 500 ? part.first(20) + digestOf(part.toUtf8()) : part;
    }
    return parts;
}

QString overlayOf(app::CaseController& controller, const QString& folder)
{
    const QString path = folder + QStringLiteral("/overlay.png");
    QFile::remove(path);
    QString refusal;
    const auto hearing = QObject::connect(&controller.exportController(), &app::ExportController::failed, &controller,
                                          [&refusal](const QString& why) { refusal = why; });
    controller.exportController().exportOverlay({600, ui::Toggle::On, ui::Toggle::Off}, path);
    const bool hasEnded = test::waitFor([&] { return QFile::exists(path) || !refusal.isEmpty(); });
    QObject::disconnect(hearing);
    return hasEnded && refusal.isEmpty() ? digestOf(contentOf(path))
                                         : QStringLiteral("could not be exported: ") + refusal;
}

/// Resets the branch list to the state after filling: tree order, scrolled to the top, no item under the pointer.
void putBack(ui::BranchPanel& branches)
{
    branches.findChild<QComboBox*>()->setCurrentIndex(0);
    branches.list()->scrollToTop();
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(branches.list()->viewport(), &leave);
}

void putBack(app::WindowHost& host, const Switches& fresh, const QByteArray& layout)
{
    ui::MainWindow& window = host.window();
    QTest::keyClick(&window.angiogramView(), Qt::Key_Escape);   // ends previews of other poses
    for (QAction* action : window.QWidget::actions()) {
        const auto was = fresh.find(action->objectName());
        if (was != fresh.end() && action->isChecked() != was->second && (was->second || !action->actionGroup())) {
            action->setChecked(was->second);
        }
    }
    while (window.angiogramView().scene().mode() != ui::OverlayMode::Centerline) {
        window.actions()[ui::Command::Outline]->trigger();
    }
    while (window.angiogramView().cutout() != ui::Cutout::Shape::None) {
        window.actions()[ui::Command::Swipe]->trigger();
    }
    window.showNormal();
    window.restoreLayout(layout);
    window.resize(1400, 900);
    putBack(window.branches());
    host.controller().branches().select({});
    host.controller().branches().hover({});
    window.setFocus();
    QTest::mouseMove(&window.header(), QPoint(2, 2));
    QApplication::processEvents();
    window.actions()[ui::Command::Fit]->trigger();
    QTest::qWait(300);
}

}   // namespace

Switches switchesOf(ui::MainWindow& window)
{
    Switches switches;
    for (const QAction* action : window.QWidget::actions()) {
        const bool isOfTheCase = action == window.actions()[ui::Command::Composite];
        if (action->isCheckable() && !isOfTheCase) {
            switches[action->objectName()] = action->isChecked();
        }
    }
    return switches;
}

QStringList caseTextOf(const core::Case& session, const QString& folder)
{
    QDir().mkpath(folder);
    const QString path = folder + QStringLiteral("/case.angiopose");
    if (const auto saved = io::saveCase(session, path.toStdString()); !saved) {
        return {QString::fromStdString(saved.error().message.text())};
    }
    return linesOf(contentOf(path));
}

/// Clears the hover state of list rows, which is transient.
void leaveRows(QWidget& panel)
{
    for (const QAbstractItemView* list : panel.findChildren<QAbstractItemView*>()) {
        QHoverEvent leaving(QEvent::HoverLeave, {-1, -1}, {-1, -1}, {-1, -1});
        QApplication::sendEvent(list->viewport(), &leaving);
    }
}

CaseSight sightOf(app::WindowHost& host, const Switches& fresh, const QByteArray& layout, const QString& folder)
{
    putBack(host, fresh, layout);
    app::CaseController& controller = host.controller();
    const core::Case& session = controller.document().current();
    static const QRegularExpression ofTheCase(
        QStringLiteral("^(?!angiopose::ui::StepButton\\|\\|Export\\|)"));   // depends on exports in this session
    CaseSight sight;
    sight.caseText = caseTextOf(session, folder);
    for (const auto& [name, panel] : panelsOf(host.window())) {
        sight.words[name] = wordsOf(*panel).filter(ofTheCase);
        leaveRows(*panel);
        sight.pictures[name] = panel->isVisible() ? panel->grab().toImage() : QImage();
    }
    sight.pictures.erase(QStringLiteral("steps"));   // the underlined current step is transient
    sight.pictures[QStringLiteral("image")] = host.window().angiogramView().grab().toImage();
    sight.exports[QStringLiteral("overlay")] = {overlayOf(controller, folder)};
    sight.exports[QStringLiteral("report")] = reportOf(controller);
    if (session.shown().result) {
        const std::string json = io::resultJson(session, *session.shown().result);
        sight.exports[QStringLiteral("result")] = linesOf(QByteArray::fromStdString(json));
    }
    return sight;
}

QStringList differenceBetween(const QString& what, const QStringList& before, const QStringList& after)
{
    for (qsizetype i = 0; i < std::max(before.size(), after.size()); ++i) {
        if (before.value(i) != after.value(i)) {
            return {QStringLiteral("%1, line %2: “%3” became “%4”")
                        .arg(what)
                        .arg(i + 1)
                        .arg(before.value(i).left(300), after.value(i).left(300))};
        }
    }
    return {};
}

QStringList differencesBetween(const CaseSight& before, const CaseSight& after, const QString& folder)
{
    QStringList found = differenceBetween(QStringLiteral("case"), before.caseText, after.caseText);
    for (const auto& [name, words] : before.words) {
        found << differenceBetween(QStringLiteral("words of ") + name, words, after.words.at(name));
    }
    for (const QString& name : {QStringLiteral("overlay"), QStringLiteral("report"), QStringLiteral("result")}) {
        const auto linesOfExport = [&name](const CaseSight& sight) {
            const auto lines = sight.exports.find(name);
            return lines == sight.exports.end() ? QStringList() : lines->second;
        };
        found << differenceBetween(QStringLiteral("export of ") + name, linesOfExport(before), linesOfExport(after));
    }
    for (const auto& [name, picture] : before.pictures) {
        if (picture != after.pictures.at(name)) {
            found << QStringLiteral("picture of ") + name;
            picture.save(folder + QStringLiteral("/%1-before.png").arg(name));
            after.pictures.at(name).save(folder + QStringLiteral("/%1-after.png").arg(name));
        }
    }
    return found;
}

}   // namespace angiopose::test
