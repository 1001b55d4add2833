#include "tests/app/gallery/gallery.h"

#include "app/case_controller.h"
#include "app/document/edit_case.h"
#include "app/files/sample_case.h"
#include "core/vessel/tree_position.h"
#include "tests/app/gallery/clipped_texts.h"
#include "tests/app/wait_for.h"
#include "tests/support/simulated_views.h"
#include "ui/dialogs/missing_inputs.h"
#include "ui/dialogs/recovery_dialog.h"
#include "ui/dialogs/series_chooser.h"
#include "ui/dialogs/study_browser.h"
#include "ui/theme/active_theme.h"
#include "ui/words/language.h"

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QImage>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace angiopose::test {
namespace {

/// True for a screenshot with so few colors that it shows nothing.
bool isEmpty(const QImage& picture)
{
    QSet<QRgb> colors;
    for (int y = 0; y < picture.height(); y += 2) {
        for (int x = 0; x < picture.width(); x += 2) {
            colors.insert(picture.pixel(x, y));
        }
    }
    return colors.size() < 4;
}

void openSample(app::CaseController& controller)
{
    const auto sample = app::writeSampleCase();
    if (sample) {
        controller.open({sample.value()});
    }
    if (!test::waitFor([&controller] { return !controller.isLoading() && controller.evaluation() != nullptr; })) {
        qFatal("The sample case did not open.");
    }
}

void runRegistration(app::CaseController& controller)
{
    controller.registration().start();
    if (!test::waitFor([&controller] { return !controller.registration().isRunning(); })) {
        qFatal("The registration did not end.");
    }
    QTest::qWait(300);
}

void unfoldAll(QWidget& window)
{
    for (ui::Section* section : window.findChildren<ui::Section*>()) {
        section->setFolded(false);
    }
    QTest::qWait(50);
}

}   // namespace

Gallery::Gallery(QString folder, QString language, QString theme)
    : folder_(std::move(folder)), language_(std::move(language)), theme_(std::move(theme))
{
    ui::applyTheme(*qApp, theme_ == QLatin1String("light") ? ui::ThemeMode::Light : ui::ThemeMode::Dark);
    ui::applyLanguage(language_);
}

void Gallery::run()
{
    ui::MainWindow window;
    app::CaseController controller(window);
    window.resize(1440, 900);
    window.show();
    if (!QTest::qWaitForWindowExposed(&window)) {
        qFatal("The window did not show.");
    }
    showWindow(window, QStringLiteral("welcome"));
    openSample(controller);
    showWindow(window, QStringLiteral("start"));
    runRegistration(controller);
    showWindow(window, QStringLiteral("registered"));
    showSteps(window);
    measure(controller);
    showWindow(window, QStringLiteral("measured"));
    window.resize(1024, 720);
    showWindow(window, QStringLiteral("small"));
    window.resize(1440, 900);
    showModes(window);
    unfoldAll(window);
    showPanels(window);
    showDialogs(window);
    showRareDialogs(window);
    showQuestions(window, controller);
    showTrial(window, controller);
    showViews(window, controller);
    window.actions()[ui::Command::SideBySide]->setChecked(false);
    window.resize(1440, 900);
    showScan(window, controller);
}

void Gallery::measure(app::CaseController& controller)
{
    using enum core::MeasurementKind;
    const core::Case& current = controller.document().current();
    const int frame = current.shown().frame;
    const auto at = core::MeasurementPlane::Vessels;
    std::vector<core::ImageMeasurement> measurements{
        {Length, at, {{130, 150}, {215, 190}}, frame, "ostium"},
        {Angle, at, {{330, 170}, {270, 250}, {370, 290}}, frame, ""},
        {Area, core::MeasurementPlane::Detector, {{120, 330}, {200, 320}, {220, 380}, {150, 410}}, frame, ""}};
    controller.document().push(std::make_unique<app::ChangeMeasurements>(
        controller.document(), app::ChangeMeasurements::Values{std::move(measurements), {}},
        [] { return QStringLiteral("Measure"); }));
    const auto& branches = current.vessels.tree->branches;
    const core::VesselBranch& marked = branches.front();
    const std::size_t middle = marked.pointsInPatient.size() / 2;
    const auto tangent = core::directionAt(*current.vessels.tree, {0, middle, 0.0});
    using enum core::VesselMarkKind;
    controller.document().push(std::make_unique<app::ChangeMarks>(
        controller.document(),
        app::ChangeMarks::Values{{{1, TargetPoint, "bend", marked.pointsInPatient[middle]},
                                  {2, OstiumRing, "ostium", marked.pointsInPatient.front(), tangent, 2.0}}},
        [] { return QStringLiteral("Mark"); }));
    controller.document().push(std::make_unique<app::ChangeObservations>(
        controller.document(), app::ChangeObservations::Values{{{1, {250, 240}, frame}}},
        [] { return QStringLiteral("See"); }));
    controller.document().push(std::make_unique<app::ChangeAnnotations>(
        controller.document(),
        app::ChangeAnnotations::Values{{{core::AnnotationKind::Arrow, {{420, 120}, {370, 160}}, "Engstelle", frame},
                                        {core::AnnotationKind::Text, {{380, 400}}, "左冠状动脉", frame}}},
        [] { return QStringLiteral("Annotate"); }));
    controller.branches().select({std::ranges::max_element(branches, {}, &core::VesselBranch::lengthMm)->id});
}

void Gallery::showDialogs(ui::MainWindow& window)
{
    using enum ui::Command;
    const std::array dialogs{std::pair{Keys, "keys"},
                             std::pair{About, "about"},
                             std::pair{ExportOverlay, "export"},
                             std::pair{ExportMovie, "movie"},
                             std::pair{ExportReport, "report"},
                             std::pair{PanelHelp, "help"},
                             std::pair{GoodFit, "good_fit"},
                             std::pair{AuxiliaryAdvice, "auxiliary"},
                             std::pair{GantryAngles, "angles"},
                             std::pair{ComparePoses, "poses"},
                             std::pair{PruneTree, "prune"},
                             std::pair{Opacification, "opacification"},
                             std::pair{BlindTrial, "blind_trial"}};
    for (const auto& [command, name] : dialogs) {
        window.actions()[command]->trigger();
        const bool isByWorker = command == GoodFit || command == GantryAngles;   // workers compute the content
        QTest::qWait(isByWorker ? 4000 : 400);
        takeDialogs(window, QString::fromLatin1(name));
    }
    window.actions()[Tour]->trigger();
    showWindow(window, QStringLiteral("tour"));
    if (auto* tour = window.findChild<QWidget*>(QStringLiteral("tour"))) {
        tour->close();
    }
}

/// Shows the dialogs that open only after a problem.
void Gallery::showRareDialogs(ui::MainWindow& window)
{
    const QString home = QStringLiteral("/studies/2026-03");
    auto* recovery = new ui::RecoveryDialog({{home + QStringLiteral("/a"), QStringLiteral("left-coronary.angiopose"),
                                              QStringLiteral("2026-03-04 10:41"), home},
                                             {home + QStringLiteral("/b"),
                                              QStringLiteral("Sample case (simulated)"),
                                              QStringLiteral("2026-03-01 08:02"),
                                              {}}},
                                            &window);
    recovery->open();
    takeDialogs(window, QStringLiteral("recovery"));
    auto* missing = new ui::MissingInputs(QStringLiteral("left-coronary.angiopose"),
                                          {home + QStringLiteral("/run-12.dcm"), home + QStringLiteral("/tree.vtp")},
                                          home, &window);
    missing->open();
    takeDialogs(window, QStringLiteral("missing_inputs"));
    auto* series = new ui::SeriesChooser(home,
                                         {{QStringLiteral("1"),
                                           QStringLiteral("Coronary CTA 0.75 B26f"),
                                           QStringLiteral("CT"),
                                           300,
                                           QStringLiteral("512 × 512 × 300"),
                                           QStringLiteral("0.35 × 0.35 × 0.50"),
                                           QStringLiteral("2026-03-04"),
                                           {},
                                           true},
                                          {QStringLiteral("2"),
                                           QStringLiteral("Topogram"),
                                           QStringLiteral("CT"),
                                           1,
                                           QStringLiteral("512 × 512"),
                                           {},
                                           QStringLiteral("2026-03-04"),
                                           {},
                                           true}},
                                         &window);
    series->open();
    takeDialogs(window, QStringLiteral("series"));
    showStudies(window);
    showArchives(window);
    window.result().solutions().showSolutions(
        {{QStringLiteral("0.93"), {}}, {QStringLiteral("0.71"), {}}, {QStringLiteral("0.64"), {}}});
    showWindow(window.result().solutions(), QStringLiteral("solutions"));
}

void Gallery::showStudies(ui::MainWindow& window)
{
    using Use = ui::StudySeriesRow::Use;
    const auto series = [](const char* key, Use use, int number, const char* modality, const char* description,
                           int images, const char* frameRate, const QStringList& notes) {
        return ui::StudySeriesRow{QString::fromLatin1(key),
                                  use,
                                  number,
                                  QString::fromLatin1(modality),
                                  QString::fromLatin1(description),
                                  images,
                                  QStringLiteral("512 × 512"),
                                  QString::fromUtf8(frameRate),
                                  1.0,
                                  QStringLiteral("HEART"),
                                  notes};
    };
    auto* browser = new ui::StudyBrowser(QStringLiteral("/media/cdrom"), &window);
    browser->showRows(
        {{QStringLiteral("p"),
          QStringLiteral("Doe Jane · 0815 · 1950-01-02"),
          {{QStringLiteral("ct"),
            QStringLiteral("2026-03-04 · Coronary CTA"),
            {series("a", Use::None, 1, "CT", "Topogram", 1, "",
                    {QStringLiteral("the images specify no position in the patient, so they do not form a volume.")}),
             series("b", Use::Vessels, 2, "CT", "Coronary CTA 0.75 B26f", 300, "0.50 mm", {})}},
           {QStringLiteral("xa"),
            QStringLiteral("2026-03-05 · Coronary angiography"),
            {series("c", Use::View, 3, "XA", "LCA", 64, "15.0 frames/s", {}),
             series("d", Use::View, 4, "XA", "RCA", 58, "15.0 frames/s", {})}}}}});
    browser->choose(QStringLiteral("b"));
    browser->choose(QStringLiteral("c"));
    browser->showProgress(1240, 3100);
    browser->open();
    QTest::qWait(100);
    take(*browser, QStringLiteral("studies_under_way"));
    browser->showEnd(QStringLiteral("3,100 files read."), {QStringLiteral("/media/cdrom/IM12: –")},
                     QStringLiteral("The DICOMDIR lists 5 series; 3 more files are not listed."));
    takeDialogs(window, QStringLiteral("studies"));
}

void Gallery::showTrial(ui::MainWindow& window, app::CaseController& controller)
{
    const QTemporaryDir folder;
    controller.poses().blindTrial().start(
        {QStringLiteral("Ada"), 7, 10.0, 5.0, folder.filePath(QStringLiteral("log.csv"))});
    showWindow(window, QStringLiteral("trial"));
    controller.poses().blindTrial().abandon();
}

void Gallery::showViews(ui::MainWindow& window, app::CaseController& controller)
{
    core::Case views = twoViewCase();
    window.actions()[ui::Command::Nudge]->setChecked(false);   // started by the blind trial
    controller.document().replace(views, {});
    window.actions()[ui::Command::SideBySide]->setChecked(true);
    QTest::qWait(2000);   // workers compute thumbnails and colors
    showWindow(window, QStringLiteral("two_views"));
    for (core::View& view : views.views) {
        view.name = "A view with a name that is rather long for the room that it has";
    }
    views.views.insert(views.views.end(), 2, views.views.back());
    views.views.back().angiogram.reset();
    controller.document().replace(std::move(views), {});
    window.resize(1024, 720);
    QTest::qWait(2000);
    showWindow(window, QStringLiteral("four_views"));
}

void Gallery::takeDialogs(QWidget& window, const QString& name)
{
    for (QDialog* dialog : window.findChildren<QDialog*>()) {
        if (dialog->isVisible()) {
            showWindow(*dialog, name);
            dialog->reject();
        }
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

void Gallery::showWindow(QWidget& window, const QString& name)
{
    QTest::qWait(150);
    take(window, name);
    QStringList clipped = clippedTexts(window);
    if (!clipped.isEmpty()) {   // only lasting clipping is an error; on a busy machine a layout may come late
        QTest::qWait(1000);
        clipped = clippedTexts(window);
    }
    for (const QString& problem : clipped) {
        problems_ << QStringLiteral("%1, %2, %3: %4").arg(language_, theme_, name, problem);
    }
}

void Gallery::showPanels(QWidget& window)
{
    QSet<QString> names;
    for (ui::Section* section : window.findChildren<ui::Section*>()) {
        if (!section->isVisible()) {
            continue;
        }
        QString name = QString::fromLatin1(section->metaObject()->className()).section(QStringLiteral("::"), -1);
        while (names.contains(name)) {
            name += QLatin1Char('_');
        }
        names.insert(name);
        showWindow(*section, name);
    }
}

void Gallery::take(QWidget& widget, const QString& name)
{
    const QImage picture = widget.grab().toImage();
    ++pictureCount_;
    if (isEmpty(picture)) {
        problems_ << QStringLiteral("%1, %2: %3 shows nothing").arg(language_, theme_, name);
    }
    if (!folder_.isEmpty()) {
        const QString file = QStringLiteral("%1_%2_%3.png").arg(name, language_, theme_);
        picture.save(QDir(folder_).filePath(file));
    }
}

}   // namespace angiopose::test
