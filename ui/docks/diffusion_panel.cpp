#include "ui/docks/diffusion_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/scene/mean_albedo.h"
#include "ui/document/document.h"
#include "ui/rows/choice_editors.h"
#include "ui/theme/metrics.h"
#include "ui/viewport/navigation.h"

namespace dermis {
namespace {

/// Three decimals at most, and no more digits than are meant.
QString lengthText(double mm) {
  if (!(mm > 0.0)) return QStringLiteral("0");
  return QString::number(mm, 'f', mm < 1.0 ? 3 : mm < 100.0 ? 2 : 0);
}

QString familyName(DiffusionFamily family) {
  return family == DiffusionFamily::Burley ? DiffusionPanel::tr("Burley") : DiffusionPanel::tr("Gaussians");
}

}  // namespace

DiffusionPanel::DiffusionPanel(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(metrics::kMargin, metrics::kMargin, metrics::kMargin, metrics::kMargin);
  column->setSpacing(metrics::kGap);
  auto* head = new QHBoxLayout();
  head->setSpacing(metrics::kGap);
  m_what = new QuietComboBox(this);
  m_what->setObjectName(QStringLiteral("diffusion.what"));
  m_what->setAccessibleName(tr("What is plotted"));
  m_what->addItems({tr("Share by radius, 2πr·R(r)"), tr("Profile, R(r)")});
  m_scale = new QuietComboBox(this);
  m_scale->setObjectName(QStringLiteral("diffusion.scale"));
  m_scale->setAccessibleName(tr("Scale of the vertical axis"));
  m_scale->addItems({tr("Linear"), tr("Logarithmic")});
  head->addWidget(m_what, 1);
  head->addWidget(m_scale);
  column->addLayout(head);
  m_plot = new DiffusionPlot(this);
  m_plot->setObjectName(QStringLiteral("diffusion.plot"));
  column->addWidget(m_plot, 1);
  m_readout = new QLabel(this);
  m_readout->setObjectName(QStringLiteral("diffusion.readout"));
  m_readout->setTextFormat(Qt::RichText);
  m_readout->setMinimumHeight(2 * fontMetrics().height());
  column->addWidget(m_readout);
  m_lengths = new QLabel(this);
  m_lengths->setObjectName(QStringLiteral("diffusion.lengths"));
  m_lengths->setTextFormat(Qt::RichText);
  m_lengths->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(m_lengths);
  m_none = new QLabel(this);
  m_none->setProperty("quiet", true);
  m_none->setAlignment(Qt::AlignCenter);
  m_none->setWordWrap(true);
  m_none->setText(tr("This material's light leaves where it entered: nothing diffuses."));
  column->addWidget(m_none, 1);

  connect(m_what, &QComboBox::currentIndexChanged, this, [this](int index) {
    m_plot->setRadial(index == 0);
    showReadout(-1.0);
  });
  connect(m_scale, &QComboBox::currentIndexChanged, this, [this](int index) { m_plot->setLogarithmic(index == 1); });
  connect(m_plot, &DiffusionPlot::hovered, this, &DiffusionPanel::showReadout);
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what != Change::Environment && what != Change::Lights && what != Change::View) refresh();
  });
  connect(&m_document, &Document::currentSlotChanged, this, &DiffusionPanel::refresh);
}

void DiffusionPanel::setPictureHeight(int pixels) {
  if (pixels == m_pictureHeight) return;
  m_pictureHeight = pixels;
  refresh();
}

void DiffusionPanel::setSeen(bool seen) {
  m_seen = seen;
  refresh();
}

void DiffusionPanel::refresh() {
  if (!m_seen) return;
  const SlotLook* look = m_document.currentLook();
  const std::shared_ptr<const ResolvedScene> scene = m_document.snapshot();
  const Material* material = look != nullptr ? &look->worn.material : nullptr;
  const bool diffuses =
      material != nullptr && (material->model == ShadingModel::Skin || material->model == ShadingModel::Eye);
  for (QWidget* part :
       {static_cast<QWidget*>(m_plot), static_cast<QWidget*>(m_readout), static_cast<QWidget*>(m_lengths)})
    part->setVisible(diffuses);
  m_none->setVisible(!diffuses);
  if (!diffuses || !scene) return;

  const qsizetype slot = m_document.slotNames().indexOf(m_document.currentSlot());
  m_albedo = slot >= 0 ? meanAlbedo(*scene, static_cast<std::size_t>(slot)) : material->parameters.baseAlbedo.rgb;
  if (material->model == ShadingModel::Eye) m_albedo = material->parameters.eyeScleraColor.rgb;
  DiffusionCurves curves;
  curves.chosen = DiffusionProfile::of(*material, m_albedo);
  if (material->model == ShadingModel::Skin) {
    Material other = *material;
    DiffusionFamily& family = other.parameters.subsurfaceProfile;
    family = family == DiffusionFamily::Burley ? DiffusionFamily::Gaussians : DiffusionFamily::Burley;
    curves.other = DiffusionProfile::of(other, m_albedo);
  }
  curves.pixelMm =
      static_cast<double>(navigation::unitsPerPixel(m_document.camera(), static_cast<float>(m_pictureHeight))) *
      static_cast<double>(m_document.millimetresPerUnit());
  m_curves = curves;
  m_plot->showCurves(curves);
  refreshLengths();
  showReadout(-1.0);
}

void DiffusionPanel::refreshLengths() {
  const std::array<QColor, 3> colours = channelColours(palette());
  const DiffusionProfile& profile = m_curves.chosen;
  const glm::dvec3 lengths = profile.lengths();
  QString rows;
  QString spoken;
  const auto row = [&](const QString& name, const std::array<double, 3>& mm) {
    rows += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td>").arg(name.toHtmlEscaped());
    for (std::size_t c = 0; c < 3; ++c)
      rows += QStringLiteral("<td align='right' style='color:%1'>&nbsp;&nbsp;%2</td>")
                  .arg(colours.at(c).name(), lengthText(mm.at(c)));
    rows += QStringLiteral("<td>&nbsp;mm</td></tr>");
    spoken +=
        tr("%1: red %2, green %3, blue %4 mm. ").arg(name, lengthText(mm[0]), lengthText(mm[1]), lengthText(mm[2]));
  };
  if (profile.family() == DiffusionFamily::Burley) {
    // The same profile, said in each of the three readings of a radius.
    std::array<double, 3> path{}, diffuse{};
    for (int c = 0; c < 3; ++c) {
      const double albedo = std::clamp(static_cast<double>(m_albedo[c]), 0.0, 1.0);
      path.at(static_cast<std::size_t>(c)) = lengths[c] * burleyScaling(RadiusReading::MeanFreePath, albedo);
      diffuse.at(static_cast<std::size_t>(c)) = lengths[c] * burleyScaling(RadiusReading::DiffuseMeanFreePath, albedo);
    }
    row(tr("Mean free path ℓ"), path);
    row(tr("Diffuse mean free path"), diffuse);
    row(tr("Burley's d"), {lengths[0], lengths[1], lengths[2]});
  } else {
    row(tr("Standard deviation"), {lengths[0], lengths[1], lengths[2]});
  }
  const double share = 1.0 - std::exp(-1.0);
  row(tr("1/e length: 63 % within"), {profile.radius(0, share), profile.radius(1, share), profile.radius(2, share)});
  m_lengths->setText(QStringLiteral("<table cellspacing='0' cellpadding='1'>%1</table>").arg(rows));
  m_lengths->setAccessibleName(spoken.trimmed());
  m_plot->setAccessibleDescription(
      tr("%1 profile of the slot %2, drawn solid. %3One pixel at the focus is %4 mm.")
          .arg(familyName(profile.family()), m_document.currentSlot(), spoken, lengthText(m_curves.pixelMm)));
}

void DiffusionPanel::showReadout(double r) {
  const QString dashes = m_curves.other ? tr(" · dashed: %1").arg(familyName(m_curves.other->family())) : QString();
  if (r < 0.0) {
    m_readout->setText(tr("solid: %1%2").arg(familyName(m_curves.chosen.family()), dashes));
    return;
  }
  const double shown = std::max(r, 1e-6 * m_plot->longestRadius());
  const glm::dvec3 value = m_plot->plotted(m_curves.chosen, shown);
  const glm::dvec3 within = m_curves.chosen.radialCdf(r);
  const std::array<QColor, 3> colours = channelColours(palette());
  const auto three = [&](const auto& words) {
    QString text;
    for (int c = 0; c < 3; ++c)
      text += QStringLiteral(" <span style='color:%1'>%2</span>")
                  .arg(colours.at(static_cast<std::size_t>(c)).name(), words(c));
    return text;
  };
  const QString values = three([&](int c) { return QString::number(value[c], 'g', 3); });
  const QString shares = three([&](int c) { return QStringLiteral("%1 %").arg(100.0 * within[c], 0, 'f', 1); });
  m_readout->setText(tr("r = %1 mm:%2 %3<br>leaves within r:%4")
                         .arg(lengthText(r), values, m_plot->radial() ? tr("1/mm") : tr("1/mm²"), shares));
}

}  // namespace dermis
