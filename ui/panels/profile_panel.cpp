#include "ui/panels/profile_panel.h"

#include "ui/panels/result_sentences.h"
#include "ui/plots/profile_plot.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double straightFromMm = 200.0;   // a vessel with a larger radius of curvature is shown as straight

QString numberOrNone(std::optional<double> value, int decimals, const QString& pattern)
{
    return value && std::isfinite(*value) ? pattern.arg(numberText(*value, decimals)) : QStringLiteral("–");
}

}   // namespace

QString stenosisText(const core::StenosisMeasure& stenosis)
{
    return ProfilePanel::tr("%1 % at %2 mm (%3 of %4 mm, %5 mm long)")
        .arg(numberText(stenosis.percent, 0), numberText(stenosis.positionMm, 1), numberText(stenosis.diameterMm, 2),
             numberText(stenosis.referenceDiameterMm, 2), numberText(stenosis.toMm - stenosis.fromMm, 1));
}

ProfilePanel::ProfilePanel(QWidget* parent)
    : Section(
          "profile", [] { return tr("Along the branch"); }, Folding::Foldable, parent),
      grid_(makeNumbers()),
      warning_(roleLabel("hint")),
      plot_(new ProfilePlot),
      table_(withText(new QPushButton, [] { return tr("All branches…"); })),
      profile_(withText(new QPushButton, [] { return tr("Profile…"); }))
{
    warning_->setWordWrap(true);
    withToolTip(table_, [] {
        return tr("Writes the length, diameters, stenosis and curvature of every branch to a CSV file.");
    });
    withToolTip(profile_, [] { return tr("Writes the diameter and curvature along this branch to a CSV file."); });
    connect(table_, &QPushButton::clicked, this, &ProfilePanel::tableExportRequested);
    connect(profile_, &QPushButton::clicked, this, &ProfilePanel::profileExportRequested);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(table_);
    buttons->addWidget(profile_);
    contentLayout()->addWidget(grid_);
    contentLayout()->addWidget(plot_);
    contentLayout()->addWidget(warning_);
    contentLayout()->addLayout(buttons);
    setFolded(true);
    showNothing({}, false);
}

QWidget* ProfilePanel::makeNumbers()
{
    const std::array<LocalizedText, NumberCount> names{
        [] { return tr("Length"); },          [] { return tr("Mean diameter"); }, [] { return tr("Min. diameter"); },
        [] { return tr("Narrowest point"); }, [] { return tr("Tortuosity"); },    [] { return tr("Sharpest bend"); }};
    auto* grid = new QWidget;
    auto* layout = new QGridLayout(grid);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setHorizontalSpacing(10);
    layout->setVerticalSpacing(2);
    layout->setColumnStretch(1, 1);
    for (std::size_t i = 0; i < names.size(); ++i) {
        numbers_[i] = roleLabel("strong");
        numbers_[i]->setWordWrap(true);
        layout->addWidget(withText(roleLabel("label"), names[i]), static_cast<int>(i), 0, Qt::AlignTop);
        layout->addWidget(numbers_[i], static_cast<int>(i), 1);
    }
    return grid;
}

void ProfilePanel::showProfile(const core::VesselBranch& branch, const core::BranchProfile& profile)
{
    setHint(displayName(branch));
    const QString millimeters = tr("%1 mm");
    numbers_[Length]->setText(numberOrNone(profile.lengthMm, 1, millimeters));
    numbers_[Diameter]->setText(numberOrNone(profile.meanDiameterMm, 2, millimeters));
    numbers_[MinDiameter]->setText(numberOrNone(profile.minDiameterMm, 2, millimeters));
    numbers_[Stenosis]->setText(profile.stenosis ? stenosisText(*profile.stenosis) : QStringLiteral("–"));
    numbers_[Tortuosity]->setText(numberOrNone(profile.tortuosity, 3, QStringLiteral("%1")));
    const double deformationMm = 1.0 / profile.maxCurvaturePerMm;
    numbers_[Curvature]->setText(deformationMm > straightFromMm ? tr("straight")
                                                                : numberOrNone(deformationMm, 1, tr("radius %1 mm")));
    const QString basis = profile.meanDiameterMm ? tr("Diameters are twice the radii of the tree; the narrowest point "
                                                      "is determined relative to the rest of the branch.")
                                                 : QString();
    warning_->setText(profile.warnings.empty() ? basis : messagesText(profile.warnings));
    warning_->show();
    plot_->showProfile(profile);
    grid_->show();
    plot_->show();
    table_->setEnabled(true);
    profile_->setEnabled(true);
}

void ProfilePanel::showNothing(const QString& why, bool hasBranches)
{
    setHint({});
    plot_->showProfile({});
    grid_->hide();
    plot_->hide();
    warning_->setText(why);
    warning_->setVisible(!why.isEmpty());
    table_->setEnabled(hasBranches);
    profile_->setEnabled(false);
}

}   // namespace angiopose::ui
